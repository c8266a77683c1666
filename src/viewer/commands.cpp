#include "viewer/commands.h"

#include <algorithm>
#include <cassert>

namespace croquis::viewer {

void Commands::add(Command command) {
    assert(std::none_of(commands_.begin(), commands_.end(), [&](const Command& c) { return c.name == command.name; }));
    assert(std::none_of(command.keys.begin(), command.keys.end(), [&](const auto& key) { return with_key(key); }));
    commands_.push_back(std::move(command));
}

const Command* Commands::with_key(std::string_view key) const {
    for (const Command& command : commands_) {
        if (std::find(command.keys.begin(), command.keys.end(), key) != command.keys.end()) return &command;
    }
    return nullptr;
}

bool Commands::press(std::string_view key) const {
    const Command* command = with_key(key);
    if (command == nullptr) return false;
    command->run();
    return true;
}

bool Commands::release(std::string_view key) const {
    const Command* command = with_key(key);
    if (command == nullptr || !command->release) return false;
    command->release();
    return true;
}

void Commands::run(std::string_view name) const {
    const auto found =
        std::find_if(commands_.begin(), commands_.end(), [&](const Command& command) { return command.name == name; });
    assert(found != commands_.end());
    found->run();
}

std::vector<std::string> Commands::groups() const {
    std::vector<std::string> groups;
    for (const Command& command : commands_) {
        if (std::find(groups.begin(), groups.end(), command.group) == groups.end()) groups.push_back(command.group);
    }
    return groups;
}

}  // namespace croquis::viewer
