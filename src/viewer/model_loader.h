// Reading models beside the user interface, which goes on meanwhile.
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "croquis/model.h"
#include "viewer/thread.h"

namespace croquis::viewer {

/// Reads one model at a time on another thread, and afterwards makes a copy of fewer triangles of a large one, for
/// small pictures and for while it moves.
class ModelLoader {
public:
    /// `wake` is called, on another thread, whenever something arrived or a further percent was read.
    explicit ModelLoader(std::function<void()> wake = [] {}) : wake_(std::move(wake)) {}
    /// Cancels, and waits until what is being read has ended.
    ~ModelLoader();
    ModelLoader(const ModelLoader&) = delete;
    ModelLoader& operator=(const ModelLoader&) = delete;

    /// Begins. What was being read before is cancelled.
    void start(const std::string& path, const std::string& texture);
    /// What is being read will not be taken, and its thread ends soon.
    void cancel();
    /// Cancels; false where a thread still runs after so long, in a parser that is not ours.
    [[nodiscard]] bool stop(std::chrono::milliseconds patience);

    /// True from `start` until the model was taken or its error told; the smaller copy is not waited for.
    [[nodiscard]] bool is_reading() const;
    /// True while anything may still arrive.
    [[nodiscard]] bool is_busy() const { return work_ != nullptr; }
    [[nodiscard]] const std::string& path() const { return path_; }
    /// How much of it is read.
    [[nodiscard]] int percent() const { return work_ ? work_->percent.load() : 100; }

    /// What has arrived since the last call; nothing most of the time.
    struct Arrival {
        std::string path;
        std::string texture;
        std::optional<Model> model;
        std::optional<Model> small_copy;
        std::string error;  ///< in place of a model
    };
    [[nodiscard]] std::optional<Arrival> take();

    /// A model of more triangles gets a smaller copy, of so many. One of very many is clustered first, which is rough
    /// and takes a hundredth of the time.
    static constexpr std::size_t many_triangles = 60'000, few_triangles = 15'000, very_many_triangles = 400'000;

private:
    struct Work {
        std::mutex mutex;
        std::optional<Arrival> arrival;
        bool model_arrived = false;
        bool is_over = false;
        std::atomic<bool> is_cancelled = false;
        std::atomic<int> percent = 0;
    };
    static void read(Work& work, const std::function<void()>& wake, const std::string& path,
                     const std::string& texture);

    std::function<void()> wake_;
    std::string path_;
    std::shared_ptr<Work> work_;
    std::list<Thread> threads_;  // the last may still run, and those that were cancelled
};

}  // namespace croquis::viewer
