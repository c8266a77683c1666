// Who draws the picture in full detail: the window itself where that is quick, else the painter beside it.
#pragma once

#include <map>
#include <string>

#include "viewer/painter.h"
#include "viewer/session.h"

namespace croquis::viewer {

class FullPicture {
public:
    FullPicture(Painter& painter, const Session& session) : painter_(painter), session_(session) {}

    /// How long one may take where it stands in the way of what moves; 0: as long as it takes.
    void set_most_milliseconds(double most) { most_milliseconds_ = most; }
    /// Another model is shown: nothing is known of it.
    void begin_model() { milliseconds_.clear(); }
    /// One in the technique of now was drawn in so long.
    void measured(double milliseconds) { milliseconds_[session_.technique_name()] = milliseconds; }

    /// True where it would stand in the way. Before it was drawn in this technique, a model of many triangles is taken
    /// to be slow.
    [[nodiscard]] bool is_slow() const;
    /// True where the window is not to draw it.
    [[nodiscard]] bool is_painters() const { return is_slow() && painter_.failure().empty(); }
    /// True where a reduced picture takes no time worth speaking of: there is a small copy, or it needs none.
    [[nodiscard]] bool can_be_reduced() const;

    /// True until the picture of now is there or on its way.
    [[nodiscard]] bool is_due(FrameSize size) const;
    /// Orders the picture of now where it is due.
    void order(FrameSize size);
    /// True while one is on its way that takes long enough to be told.
    [[nodiscard]] bool is_awaited() const;
    /// Puts a picture on the canvas and says true; false where something has changed since it was ordered.
    bool take(const Painter::Delivery& delivery, FrameSize size, Session& session, Canvas& canvas);

    static constexpr std::size_t many_triangles = 200'000;

private:
    Painter& painter_;
    const Session& session_;
    double most_milliseconds_ = 0;
    std::map<std::string, double> milliseconds_;  // of the last one in each technique
    long long ordered_revision_ = -1;
    FrameSize ordered_size_{0, 0};
};

}  // namespace croquis::viewer
