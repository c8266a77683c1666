#include "viewer/recording.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "video/video_writer.h"

namespace croquis::viewer {
namespace {

// For how long a picture stands is known when the next one comes, and until then nothing is to do. But what stands for
// long is written now and then: too much to write at once, and the next pictures would find no room.
constexpr std::chrono::seconds longest_wait(5);

}  // namespace

Recording::Recording(std::string path, Picture first, Time now, std::size_t most_bytes)
    : path_(std::move(path)),
      begun_(now),
      most_bytes_(most_bytes),
      options_{first.width(), first.height(), frame_rate} {
    waiting_.push_back({std::make_unique<Picture>(std::move(first)), 0});
    thread_ = std::thread([this] { write(); });
}

Recording::~Recording() {
    end(std::chrono::steady_clock::now());
    wait();
}

void Recording::wait() {
    if (thread_.joinable()) thread_.join();
}

// The first frame that is seen no sooner than that time.
long long Recording::frame_at(Time time) const { return (long long)(std::ceil(seconds(time) * frame_rate)); }

bool Recording::has_room(std::size_t bytes) const {
    return waiting_.size() < 2 || (waiting_.size() + 1) * bytes <= most_bytes_;
}

void Recording::add(Picture picture, Time now) {
    const std::lock_guard lock(mutex_);
    if (last_frame_ >= 0 || is_over_) return;
    const long long frame = frame_at(now);
    if (waiting_.back().first_frame >= frame) {  // the one before was seen in no frame
        waiting_.back().picture = std::make_unique<Picture>(std::move(picture));
    } else if (has_room(picture.pixels().size())) {
        waiting_.push_back({std::make_unique<Picture>(std::move(picture)), frame});
    } else {
        waiting_.back() = {std::make_unique<Picture>(std::move(picture)), frame};
    }
    has_news_.notify_one();
}

void Recording::end(Time now) {
    const std::lock_guard lock(mutex_);
    if (last_frame_ >= 0) return;
    const Shown& newest = waiting_.back();
    last_frame_ = std::max(frame_at(now), newest.first_frame + (newest.picture ? 1 : 0));
    has_news_.notify_one();
}

bool Recording::is_over() const {
    const std::lock_guard lock(mutex_);
    return is_over_;
}

std::string Recording::error() const {
    const std::lock_guard lock(mutex_);
    return error_;
}

// A thread's exceptions end the program: all become a message. What is drawn goes before what is encoded.
void Recording::write() {
    constexpr int nicer = 10;
    ::setpriority(PRIO_PROCESS, id_t(::gettid()), nicer);  // of a thread alone, on Linux
    std::string error;
    try {
        write_pictures();
    } catch (const std::exception& mistake) {
        error = mistake.what();
    }
    const std::lock_guard lock(mutex_);
    error_ = error;
    is_over_ = true;
}

void Recording::write_pictures() {
    video::VideoWriter writer(path_, options_);
    while (const auto standing = take()) {
        long long repeated = standing->frames;
        if (const auto& picture = standing->picture) {
            writer.add({picture->width(), picture->height(), picture->pixels()});
            --repeated;
        }
        writer.repeat(repeated);
    }
    writer.finish();
}

std::optional<Recording::Standing> Recording::take() {
    std::unique_lock lock(mutex_);
    const auto is_known = [this] { return waiting_.size() > 1 || last_frame_ >= 0; };
    const bool is_over = has_news_.wait_for(lock, longest_wait, is_known);
    if (waiting_.empty()) return std::nullopt;
    Shown& oldest = waiting_.front();
    const long long until = waiting_.size() > 1 ? waiting_[1].first_frame
                            : is_over           ? last_frame_
                                                : frame_at(std::chrono::steady_clock::now());
    Standing standing{std::move(oldest.picture), until - oldest.first_frame};
    oldest.first_frame = until;
    if (is_over) waiting_.pop_front();
    return standing;
}

}  // namespace croquis::viewer
