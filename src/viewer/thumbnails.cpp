#include "viewer/thumbnails.h"

#include <algorithm>

#include "base/error.h"

namespace croquis::viewer {

void Thumbnails::restart() {
    wanted_.clear();
    tried_.clear();
}

void Thumbnails::want(const std::string& technique) {
    if (tried_.find(technique) != tried_.end()) return;
    if (std::find(wanted_.begin(), wanted_.end(), technique) == wanted_.end()) wanted_.push_back(technique);
}

void Thumbnails::draw_one(const Session& session) {
    if (wanted_.empty() || session.small_model() == nullptr) return;
    const std::string name = wanted_.front();
    wanted_.erase(wanted_.begin());
    Known& known = tried_[name];
    try {
        Technique technique = renderer_.open_technique(name);
        known.help = technique.help();
        DrawOptions options = session.options(size);
        options.samples = 4;
        options.view = View();
        options.view.parallel = session.arrangement().is_parallel();
        pictures_.put(name, renderer_.draw(*session.small_model(), technique, options));
    } catch (const Error& mistake) {
        known.error = mistake.what();
    }
}

Thumbnails::Known Thumbnails::known(const std::string& technique) const {
    const auto found = tried_.find(technique);
    return found == tried_.end() ? Known() : found->second;
}

}  // namespace croquis::viewer
