// A thread whose end can be waited for a while, and no longer.
#pragma once

#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace croquis::viewer {

class Thread {
public:
    template <typename Work>
    explicit Thread(Work work) {
        std::packaged_task<void()> task(std::move(work));
        end_ = task.get_future();
        thread_ = std::thread(std::move(task));
    }
    /// Waits for its end.
    ~Thread() { thread_.join(); }
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    /// Waits so long at most; true when it has come to its end.
    [[nodiscard]] bool ends_within(std::chrono::milliseconds patience) const {
        return end_.wait_for(patience) == std::future_status::ready;
    }

private:
    std::future<void> end_;
    std::thread thread_;
};

}  // namespace croquis::viewer
