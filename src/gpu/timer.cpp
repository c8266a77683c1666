#include "gpu/timer.h"

#include <epoxy/gl.h>

#include <utility>

namespace croquis::gpu {
namespace {

bool has_timer_queries(const Context& context) {
    if (context.is_software()) return false;
    return context.api() == Api::gl || epoxy_has_gl_extension("GL_EXT_disjoint_timer_query");
}

}  // namespace

StretchTimer::StretchTimer(Context& context) : context_(&context), uses_queries_(has_timer_queries(context)) {}

StretchTimer::~StretchTimer() {
    if (!queries_.empty()) glDeleteQueries(GLsizei(queries_.size()), queries_.data());
}

void StretchTimer::begin() {
    if (uses_queries_) {
        queries_.emplace_back();
        glGenQueries(1, &queries_.back());
        glBeginQuery(GL_TIME_ELAPSED, queries_.back());
        return;
    }
    context_->finish();
    begun_ = std::chrono::steady_clock::now();
}

void StretchTimer::end() {
    if (uses_queries_) {
        glEndQuery(GL_TIME_ELAPSED);
        return;
    }
    context_->finish();
    finished_.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun_).count());
}

std::vector<double> StretchTimer::milliseconds() {
    for (const unsigned query : queries_) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        finished_.push_back(double(nanoseconds) * 1e-6);
    }
    if (!queries_.empty()) glDeleteQueries(GLsizei(queries_.size()), queries_.data());
    queries_.clear();
    return std::exchange(finished_, {});
}

}  // namespace croquis::gpu
