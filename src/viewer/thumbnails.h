// A small picture of the model in each technique, drawn by the painter one after the other while nothing else happens.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "viewer/painter.h"
#include "viewer/picture_textures.h"
#include "viewer/session.h"

namespace croquis::viewer {

class Thumbnails {
public:
    explicit Thumbnails(Painter& painter) : painter_(painter) {}

    /// Begins anew: the model is another, or files changed. Old pictures stay until new ones take their place.
    void restart();

    /// A technique's row came in sight: its picture is drawn before others.
    void want(const std::string& technique);

    /// True while a picture is wanted that was not ordered.
    [[nodiscard]] bool has_work() const { return !wanted_.empty(); }
    /// Orders one of those that are wanted. A technique that fails is not tried again until `restart`.
    void order_one(const Session& session);
    void take(const Painter::Delivery& delivery);

    void show(const std::string& technique, const ImVec2& place) const { pictures_.show(technique, place); }
    /// What is known of a technique whose picture was tried.
    struct Known {
        std::string help;
        std::string error;  ///< why it cannot be drawn; empty where it can
    };
    [[nodiscard]] Known known(const std::string& technique) const;

    /// Larger than they are shown: else lines would be as wide as in a large picture.
    static constexpr FrameSize size{288, 216};

private:
    Painter& painter_;
    PictureTextures pictures_;
    std::vector<std::string> wanted_;
    std::map<std::string, Known> tried_;
};

}  // namespace croquis::viewer
