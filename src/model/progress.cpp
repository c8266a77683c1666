#include "model/progress.h"

#include <utility>

#include "base/error.h"

namespace croquis::model {

Progress::Progress(std::string name, Listener listener) {
    if (listener) work_ = std::make_shared<Work>(Work{std::move(name), std::move(listener)});
}

Progress Progress::part(double from, double to) const {
    Progress part = *this;
    part.from_ = from_ + from * (to_ - from_);
    part.to_ = from_ + to * (to_ - from_);
    return part;
}

void Progress::reach(double share) const {
    if (!work_) return;
    if (!work_->is_cancelled) work_->is_cancelled = !work_->listener(from_ + share * (to_ - from_));
    if (work_->is_cancelled) fail("{}: cancelled", work_->name);
}

}  // namespace croquis::model
