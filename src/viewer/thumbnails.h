// A small picture of the model in each technique, drawn one after the other while nothing else happens.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "viewer/picture_textures.h"
#include "viewer/session.h"

namespace croquis::viewer {

class Thumbnails {
public:
    explicit Thumbnails(Renderer& renderer) : renderer_(renderer) {}

    /// Begins anew: the model is another, or files changed. Old pictures stay until new ones take their place.
    void restart();

    /// A technique's row came in sight: its picture is drawn before others.
    void want(const std::string& technique);

    [[nodiscard]] bool has_work() const { return !wanted_.empty(); }
    /// Draws one of those that are wanted. A technique that fails is not tried again until `restart`.
    void draw_one(const Session& session);

    void show(const std::string& technique, const ImVec2& place) const { pictures_.show(technique, place); }
    /// What is known of a technique whose picture was tried.
    struct Known {
        std::string help;
        std::string error;  ///< why it cannot be drawn; empty where it can
    };
    [[nodiscard]] Known known(const std::string& technique) const;

    static constexpr FrameSize size{144, 108};

private:
    Renderer& renderer_;
    PictureTextures pictures_;
    std::vector<std::string> wanted_;
    std::map<std::string, Known> tried_;
};

}  // namespace croquis::viewer
