// The panel of a technique's variables, made from their descriptors alone.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/messages.h"
#include "viewer/picture_textures.h"
#include "viewer/session.h"

namespace croquis::viewer {

class VariablesPanel {
public:
    explicit VariablesPanel(Renderer& renderer) : renderer_(renderer) {}

    /// Shows the variables of the session's technique at the cursor of the window, and carries out what a person
    /// changes. A value that cannot be is told and not taken.
    void show(Session& session, Messages& messages);

    /// Files changed: names and previews of textures are found anew.
    void forget_textures();

private:
    void show_pass(std::span<const PassVariable> variables, Session& session, Messages& messages);
    void show_switch(const PassVariable& render, Session& session, Messages& messages);
    void show_variable(const PassVariable& variable, Session& session, Messages& messages);
    [[nodiscard]] std::string edited(const PassVariable& variable);
    [[nodiscard]] std::string chosen_texture(const PassVariable& variable);
    void show_preview(const std::string& texture);

    Renderer& renderer_;
    PictureTextures previews_;
    std::vector<std::string> previewed_;  // also those that failed
    std::vector<std::string> texture_names_;
    float width_ = 0;  // of the widget that is shown next
};

}  // namespace croquis::viewer
