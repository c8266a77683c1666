#include "viewer/full_picture.h"

namespace croquis::viewer {
namespace {

const Painter::Purpose purpose{Painter::Purpose::Kind::full_picture, {}};

}  // namespace

bool FullPicture::is_slow() const {
    if (most_milliseconds_ <= 0 || session_.model() == nullptr) return false;
    const auto known = milliseconds_.find(session_.technique_name());
    if (known == milliseconds_.end()) return session_.model()->triangle_count() > many_triangles;
    return known->second > most_milliseconds_;
}

bool FullPicture::can_be_reduced() const {
    return session_.model() != nullptr && session_.small_model()->triangle_count() <= many_triangles;
}

bool FullPicture::is_due(FrameSize size) const {
    const bool is_ordered = session_.revision() == ordered_revision_ && size == ordered_size_;
    return !is_ordered && session_.is_stale(size, Detail::full);
}

void FullPicture::order(FrameSize size) {
    if (!is_due(size)) return;
    ordered_revision_ = session_.revision();
    ordered_size_ = size;
    painter_.order(session_.order(purpose, session_.options(size)));
}

bool FullPicture::is_awaited() const {
    constexpr double long_milliseconds = 1000;
    if (!painter_.has_order(purpose)) return false;
    const auto known = milliseconds_.find(session_.technique_name());
    return known == milliseconds_.end() || known->second > long_milliseconds;
}

bool FullPicture::take(const Painter::Delivery& delivery, FrameSize size, Session& session, Canvas& canvas) {
    const FrameSize drawn{delivery.order.options.width, delivery.order.options.height};
    if (delivery.order.revision != session.revision() || drawn != size) return false;
    if (delivery.picture) {
        canvas.put(*delivery.picture);
        measured(delivery.milliseconds);
    }
    session.note_drawn(size, Detail::full);
    return true;
}

}  // namespace croquis::viewer
