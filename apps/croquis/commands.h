// The program's commands. Each adds its options to the command line and its work to run when it is chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "croquis/croquis.h"

namespace croquis::app {

/// Where to look for data and what to draw with: options that several commands share.
struct Common {
    std::vector<std::string> data_folders;
    std::string api;
    std::string device;
    bool verbose = false;

    void add_to(CLI::App& command);
    [[nodiscard]] Renderer::Choice choice() const { return {api, device, data_folders}; }
};

/// What to do for a command; the result is the program's exit status.
using Run = std::function<int()>;
using Commands = std::map<CLI::App*, Run>;

void add_render_command(CLI::App& program, Commands& commands);
/// `command_line` is written into the files.
void add_lines_command(CLI::App& program, Commands& commands, const std::string& command_line);
void add_bench_command(CLI::App& program, Commands& commands);
void add_view_command(CLI::App& program, Commands& commands);
void add_list_command(CLI::App& program, Commands& commands);
void add_describe_command(CLI::App& program, Commands& commands);
void add_doctor_command(CLI::App& program, Commands& commands);

}  // namespace croquis::app
