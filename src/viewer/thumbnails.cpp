#include "viewer/thumbnails.h"

#include <algorithm>
#include <utility>

namespace croquis::viewer {
namespace {

Painter::Purpose purpose_of(const std::string& technique) { return {Painter::Purpose::Kind::small_picture, technique}; }

}  // namespace

void Thumbnails::restart() {
    for (const auto& [technique, known] : tried_) painter_.withdraw(purpose_of(technique));
    wanted_.clear();
    tried_.clear();
}

void Thumbnails::want(const std::string& technique) {
    if (tried_.find(technique) != tried_.end()) return;
    if (std::find(wanted_.begin(), wanted_.end(), technique) == wanted_.end()) wanted_.push_back(technique);
}

void Thumbnails::order_one(const Session& session) {
    if (wanted_.empty() || session.small_model() == nullptr) return;
    const std::string name = wanted_.front();
    wanted_.erase(wanted_.begin());
    tried_[name];
    DrawOptions options = session.options(size);
    options.samples = 4;
    options.view = View();
    options.view.parallel = session.arrangement().is_parallel();
    painter_.order({.purpose = purpose_of(name),
                    .technique = name,
                    .text = {},
                    .model = *session.small_model(),
                    .options = options,
                    .revision = 0});
}

void Thumbnails::take(const Painter::Delivery& delivery) {
    const std::string& technique = delivery.order.technique;
    if (delivery.picture) pictures_.put(technique, *delivery.picture);
    tried_[technique] = {delivery.help, delivery.error};
}

Thumbnails::Known Thumbnails::known(const std::string& technique) const {
    const auto found = tried_.find(technique);
    return found == tried_.end() ? Known() : found->second;
}

}  // namespace croquis::viewer
