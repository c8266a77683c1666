#include "viewer/model_loader.h"

#include <exception>
#include <utility>

#include "base/error.h"
#include "base/log.h"

namespace croquis::viewer {

ModelLoader::~ModelLoader() {
    cancel();
    for (std::thread& thread : threads_) thread.join();
}

void ModelLoader::start(const std::string& path, const std::string& texture) {
    cancel();
    path_ = path;
    begun_ = std::chrono::steady_clock::now();
    work_ = std::make_shared<Work>();
    threads_.emplace_back([work = work_, path, texture] { read(work, path, texture); });
}

// A reader may throw what is not ours, for want of memory for one: the session goes on.
void ModelLoader::read(const std::shared_ptr<Work>& work, const std::string& path, const std::string& texture) {
    Arrival arrival{.path = path, .texture = texture, .model = {}, .small_copy = {}, .error = {}};
    try {
        arrival.model = Model::load(path, texture);
    } catch (const std::exception& error) {
        arrival.error = error.what();
    }
    const std::optional<Model> model = arrival.model;
    {
        const std::lock_guard lock(work->mutex);
        work->arrival = std::move(arrival);
    }
    std::optional<Model> small_copy;
    if (model && model->triangle_count() > many_triangles && !work->is_cancelled) {
        try {
            small_copy = model->simplified(few_triangles);
        } catch (const std::exception& error) {
            note(fmt::format("{}: no smaller copy: {}", path, error.what()));
        }
    }
    const std::lock_guard lock(work->mutex);
    if (small_copy) {
        if (!work->arrival) work->arrival = Arrival{path, texture, {}, {}, {}};
        work->arrival->small_copy = std::move(small_copy);
    }
    work->is_over = true;
}

void ModelLoader::cancel() {
    if (work_) work_->is_cancelled = true;
    work_.reset();
}

bool ModelLoader::is_reading() const {
    if (!work_) return false;
    const std::lock_guard lock(work_->mutex);
    return !work_->model_arrived;
}

double ModelLoader::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
}

std::optional<ModelLoader::Arrival> ModelLoader::take() {
    if (!work_) return std::nullopt;
    std::optional<Arrival> arrival;
    bool is_over = false;
    {
        const std::lock_guard lock(work_->mutex);
        arrival = std::exchange(work_->arrival, std::nullopt);
        if (arrival && (arrival->model || !arrival->error.empty())) work_->model_arrived = true;
        is_over = work_->is_over;
    }
    if (is_over) work_.reset();
    return arrival;
}

}  // namespace croquis::viewer
