// Reading models beside the user interface, which goes on meanwhile.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "croquis/model.h"

namespace croquis::viewer {

/// Reads one model at a time on another thread, and afterwards makes a copy of fewer triangles of a large one, for
/// small pictures and for while it moves.
class ModelLoader {
public:
    ModelLoader() = default;
    /// Waits for what is still being read: a reader cannot be stopped in its middle.
    ~ModelLoader();
    ModelLoader(const ModelLoader&) = delete;
    ModelLoader& operator=(const ModelLoader&) = delete;

    /// Begins. What was being read before is cancelled.
    void start(const std::string& path, const std::string& texture);
    /// What is being read will not be taken; its thread runs to its end unheard.
    void cancel();

    /// True from `start` until the model was taken or its error told; the smaller copy is not waited for.
    [[nodiscard]] bool is_reading() const;
    /// True while anything may still arrive.
    [[nodiscard]] bool is_busy() const { return work_ != nullptr; }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] double seconds() const;

    /// What has arrived since the last call; nothing most of the time.
    struct Arrival {
        std::string path;
        std::string texture;
        std::optional<Model> model;
        std::optional<Model> small_copy;
        std::string error;  ///< in place of a model
    };
    [[nodiscard]] std::optional<Arrival> take();

    /// A model of more triangles gets a smaller copy, of so many.
    static constexpr std::size_t many_triangles = 60'000, few_triangles = 15'000;

private:
    struct Work {
        std::mutex mutex;
        std::optional<Arrival> arrival;
        bool model_arrived = false;
        bool is_over = false;
        std::atomic<bool> is_cancelled = false;
    };
    static void read(const std::shared_ptr<Work>& work, const std::string& path, const std::string& texture);

    std::string path_;
    std::chrono::steady_clock::time_point begun_;
    std::shared_ptr<Work> work_;
    std::vector<std::thread> threads_;  // the last may still run, and those that were cancelled
};

}  // namespace croquis::viewer
