// Everything a person can ask of the viewer by key or menu, in one list: keys, menus and the help screen come from it.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace croquis::viewer {

struct Command {
    std::string group;  ///< heading in menus and on the help screen
    std::string name;
    std::vector<std::string> keys;  ///< "F1", "Tab", "Ctrl+S", "R"; the help screen shows all
    std::string help;               ///< what it does, for the help screen and as tooltip
    std::function<void()> run;
    std::function<bool()> is_on{};    ///< for what is switched on and off: draws a check mark
    std::function<void()> release{};  ///< for what lasts as long as its key is held
};

class Commands {
public:
    /// Names and keys must be new: two commands of one key would hide each other.
    void add(Command command);

    /// Runs the command of that key. False where no command has it.
    bool press(std::string_view key) const;
    bool release(std::string_view key) const;

    /// Runs a command by its name, which must be one.
    void run(std::string_view name) const;

    [[nodiscard]] const std::vector<Command>& all() const { return commands_; }
    /// The groups, in the order in which they first appeared.
    [[nodiscard]] std::vector<std::string> groups() const;

private:
    [[nodiscard]] const Command* with_key(std::string_view key) const;

    std::vector<Command> commands_;
};

}  // namespace croquis::viewer
