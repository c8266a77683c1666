#include "base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <mutex>
#include <unordered_set>

namespace croquis {
namespace {

spdlog::logger& logger() {
    static const auto shared = [] {
        auto created =
            std::make_shared<spdlog::logger>("croquis", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
        created->set_pattern("%n: %^%l%$: %v");
        return created;
    }();
    return *shared;
}

bool is_first(const std::string& message) {
    static std::mutex mutex;
    static std::unordered_set<std::string> seen;
    constexpr std::size_t most_remembered = 1000;
    const std::lock_guard lock(mutex);
    return seen.size() < most_remembered && seen.insert(message).second;
}

}  // namespace

std::string printable(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) {
            line += fmt::format("\\x{:02x}", code);
        } else {
            line += c;
        }
    }
    return line;
}

void warn(const std::string& message) {
    if (is_first(message)) logger().warn(printable(message));
}

void note(const std::string& message) { logger().debug(printable(message)); }

void set_verbose() { logger().set_level(spdlog::level::debug); }

}  // namespace croquis
