// croquis: turns models into drawings from the command line.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "base/log.h"
#include "base/names.h"
#include "commands.h"
#include "progress.h"

namespace croquis::app {
namespace {

constexpr int exit_user_error = 2;

int refuse(const std::string& message) {
    complain(message);
    return exit_user_error;
}

// The option nearest to one that does not exist, among those of the command that was chosen.
std::string unknown_argument(const CLI::App& program) {
    const CLI::App* command = &program;
    if (!program.get_subcommands().empty()) command = program.get_subcommands().front();
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options()) {
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    }
    if (command == &program) {
        for (const CLI::App* other : program.get_subcommands({})) known.push_back(other->get_name());
    }
    const std::vector<std::string> unknown = program.remaining(true);
    const std::string first = unknown.empty() ? "" : unknown.front();
    return fmt::format("unknown argument \"{}\"{}", first, suggestion(first.substr(0, first.find('=')), known));
}

// What was typed, as a shell would take it.
std::string command_line(int argc, char** argv) {
    std::string line = "croquis";
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        line += ' ';
        if (!word.empty() && word.find_first_of(" \t\n'\"\\$&|;<>()*?`~#!{}[]") == std::string::npos) {
            line += word;
            continue;
        }
        line += '\'';
        for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += '\'';
    }
    return line;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

int run(int argc, char** argv) {
    CLI::App program("Turns 3-D models into drawings, in real time.", "croquis");
    program.set_version_flag("--version", "croquis " CROQUIS_VERSION);
    program.require_subcommand(1);
    Commands commands;
    add_render_command(program, commands);
    add_lines_command(program, commands, command_line(argc, argv));
    add_bench_command(program, commands);
    add_view_command(program, commands);
    add_list_command(program, commands);
    add_describe_command(program, commands);
    add_doctor_command(program, commands);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {  // --help, --version
        return program.exit(success);
    } catch (const CLI::ExtrasError&) {
        return refuse(unknown_argument(program));
    } catch (const CLI::ParseError& error) {
        if (argc < 2)
            return refuse(
                "expected a command: render, lines, bench, view, list, describe or doctor; croquis --help tells more");
        if (program.get_subcommands().empty() && argc >= 2) return refuse(unknown_argument(program));
        return refuse(first_line(error.what()));
    }
    return commands.at(program.get_subcommands().front())();
}

}  // namespace

void Common::add_to(CLI::App& command) {
    command.add_option("--data", data_folders, "A folder of your own components, techniques, shaders and textures");
    command.add_option("--gl", api, "gl (OpenGL 3.3) or gles (OpenGL ES 3.0); also CROQUIS_GL");
    command.add_option("--device", device, "auto, hardware or software; also CROQUIS_DEVICE");
    command.add_flag_callback(
        "--verbose", [] { set_verbose(); }, "Say more on standard error");
}

}  // namespace croquis::app

int main(int argc, char** argv) {
    try {
        return croquis::app::run(argc, argv);
    } catch (const croquis::Error& error) {
        return croquis::app::refuse(error.what());
    } catch (const std::bad_alloc&) {
        return croquis::app::refuse("out of memory");
    } catch (const std::exception& error) {
        return croquis::app::refuse(fmt::format("unexpected: {}", error.what()));
    }
}
