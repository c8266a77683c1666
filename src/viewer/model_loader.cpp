#include "viewer/model_loader.h"

#include <exception>
#include <utility>

#include "base/error.h"
#include "base/log.h"

namespace croquis::viewer {
namespace {

// A model that cannot be brought to few triangles carefully may do with what clustering left.
Model small_copy_of(const Model& model) {
    constexpr std::size_t clustered_triangles = 100'000;
    if (model.triangle_count() <= ModelLoader::very_many_triangles) {
        return model.simplified(ModelLoader::few_triangles);
    }
    Model rough = model.clustered(clustered_triangles);
    try {
        return rough.simplified(ModelLoader::few_triangles);
    } catch (const Error& error) {
        note(error.what());
        return rough;
    }
}

}  // namespace

ModelLoader::~ModelLoader() { cancel(); }

void ModelLoader::start(const std::string& path, const std::string& texture) {
    cancel();
    std::erase_if(threads_, [](const Thread& thread) { return thread.ends_within(std::chrono::milliseconds(0)); });
    path_ = path;
    work_ = std::make_shared<Work>();
    threads_.emplace_back([work = work_, wake = wake_, path, texture] { read(*work, wake, path, texture); });
}

// A reader may throw what is not ours, for want of memory for one: the session goes on.
void ModelLoader::read(Work& work, const std::function<void()>& wake, const std::string& path,
                       const std::string& texture) {
    Arrival arrival{.path = path, .texture = texture, .model = {}, .small_copy = {}, .error = {}};
    const auto tell = [&](double share) {
        const int percent = int(100 * share);
        if (work.percent.exchange(percent) != percent) wake();
        return !work.is_cancelled;
    };
    try {
        arrival.model = Model::load(path, texture, tell);
    } catch (const std::exception& error) {
        arrival.error = error.what();
    }
    const std::optional<Model> model = arrival.model;
    {
        const std::lock_guard lock(work.mutex);
        work.arrival = std::move(arrival);
    }
    wake();
    std::optional<Model> small_copy;
    if (model && model->triangle_count() > many_triangles && !work.is_cancelled) {
        try {
            small_copy = small_copy_of(*model);
        } catch (const std::exception& error) {
            note(fmt::format("{}: no smaller copy: {}", path, error.what()));
        }
    }
    {
        const std::lock_guard lock(work.mutex);
        if (small_copy) {
            if (!work.arrival) work.arrival = Arrival{path, texture, {}, {}, {}};
            work.arrival->small_copy = std::move(small_copy);
        }
        work.is_over = true;
    }
    wake();
}

void ModelLoader::cancel() {
    if (work_) work_->is_cancelled = true;
    work_.reset();
}

bool ModelLoader::stop(std::chrono::milliseconds patience) {
    cancel();
    const auto deadline = std::chrono::steady_clock::now() + patience;
    for (const Thread& thread : threads_) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
        if (!thread.ends_within(left)) return false;
    }
    return true;
}

bool ModelLoader::is_reading() const {
    if (!work_) return false;
    const std::lock_guard lock(work_->mutex);
    return !work_->model_arrived;
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
