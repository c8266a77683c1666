// From text to statements: what is kept of each rule of the grammars, and what is said where one does not match
// (seed C, 2.1-2.2.3).
#include "framework/grammar.h"

#include <fmt/format.h>

#include <cstdlib>
#include <span>
#include <tao/pegtl.hpp>
#include <type_traits>
#include <utility>

#include "base/names.h"
#include "framework/grammar_rules.h"
#include "framework/grammar_source.h"

namespace croquis::framework {
namespace {

namespace peg = tao::pegtl;
using namespace grammar_rules;

// ---- What is known while parsing ------------------------------------------------------------------------------------

/// The brackets that are open, for the error at a file's end.
struct OpenBracket {
    std::string what;
    std::uint32_t line = 0;
};

struct Parsing {
    SourceText source;
    std::size_t next = 0;        // the first byte of the token that comes now
    Word name;                   // the last name read
    Word text;                   // the last quoted text read, adjacent ones joined
    std::size_t text_start = 0;  // where the last quoted piece opens
    std::vector<Setting> settings;
    std::vector<OpenBracket> open;

    std::vector<ComponentStatement> components;
    std::vector<TechniqueStatement> statements;

    [[nodiscard]] Place here() { return source.place(next); }

    template <typename... Args>
    [[noreturn]] void fail_here(fmt::format_string<Args...> format, Args&&... args) {
        fail_at(position(source.file(), here()), format, std::forward<Args>(args)...);
    }

    [[noreturn]] void fail_expected(std::string_view expected, std::span<const std::string> keywords) {
        std::string tail = suggestion(source.word(next), keywords);
        // An opening bracket where none belongs most likely begins what should stand after the open one.
        if (!open.empty() && (next >= source.text().size() || source.text()[next] == '{')) {
            tail = fmt::format("; the '{{' of {} in line {} is not closed", open.back().what, open.back().line);
        }
        fail_here("expected {}, found {}{}", expected, source.found(next), tail);
    }
};

// ---- Errors --------------------------------------------------------------------------------------------------------

const std::vector<std::string> component_keywords = {"component"};
const std::vector<std::string> technique_keywords = {"pass", "include", "modify", "help"};
const std::vector<std::string> body_keywords = {"bool",    "int",     "number", "string", "vector2", "vector3",
                                                "vector4", "texture", "rgb",    "rgba",   "modify",  "help"};

template <typename Rule>
constexpr bool never_fails = false;
template <typename... Rules>
constexpr bool never_fails<peg::opt<Rules...>> = true;
template <typename... Rules>
constexpr bool never_fails<peg::star<Rules...>> = true;

template <typename Rule>
struct control : peg::normal<Rule> {
    template <typename Input>
    [[noreturn]] static void raise(const Input& in, Parsing& state) {
        const auto here = static_cast<std::size_t>(in.current() - state.source.text().data());
        if constexpr (std::is_same_v<Rule, closing_quote>) {
            state.next = state.text_start;
            state.fail_here("this quoted text has no closing '\"' in its line");
        } else if constexpr (std::is_same_v<Rule, escaped>) {
            state.next = here - 1;
            state.fail_here("expected \\\" or \\\\ here: a backslash in a quoted text stands before these only");
        } else if constexpr (!never_fails<Rule>) {
            std::span<const std::string> keywords;
            if constexpr (std::is_same_v<Rule, end_of_components>) keywords = component_keywords;
            if constexpr (std::is_same_v<Rule, end_of_technique>) keywords = technique_keywords;
            state.fail_expected(Rule::expected, keywords);
        }
        std::abort();  // PEGTL asks for an error even of rules that cannot fail
    }
};

// ---- What is kept ---------------------------------------------------------------------------------------------------

template <typename Rule>
struct action : peg::nothing<Rule> {};

template <>
struct action<skip> {
    template <typename Input>
    static void apply(const Input& in, Parsing& state) {
        state.next = static_cast<std::size_t>(in.end() - state.source.text().data());
    }
};

template <>
struct action<name_shape> {
    template <typename Input>
    static void apply(const Input& in, Parsing& state) {
        state.name = {in.string(), state.here()};
    }
};

template <>
struct action<text_start> {
    static void apply0(Parsing& state) { state.text = {{}, state.here()}; }
};

template <>
struct action<opening_quote> {
    template <typename Input>
    static void apply(const Input& in, Parsing& state) {
        state.text_start = static_cast<std::size_t>(in.begin() - state.source.text().data());
    }
};

struct append_text {
    template <typename Input>
    static void apply(const Input& in, Parsing& state) {
        state.text.text += in.string_view();
    }
};
template <>
struct action<plain_text> : append_text {};
template <>
struct action<escaped> : append_text {};

template <>
struct action<setting_name> {
    static void apply0(Parsing& state) { state.settings.push_back({state.name, {}, false}); }
};

template <>
struct action<text_value> {
    static void apply0(Parsing& state) {
        state.settings.back().value = {std::move(state.text)};
        state.settings.back().is_text = true;
    }
};

template <>
struct action<value_word> {
    template <typename Input>
    static void apply(const Input& in, Parsing& state) {
        state.settings.back().value.push_back({in.string(), state.here()});
    }
};

// -- of descriptors

template <>
struct action<component_word> {
    static void apply0(Parsing& state) { state.components.emplace_back(); }
};

template <>
struct action<component_name> {
    static void apply0(Parsing& state) { state.components.back().name = state.name; }
};

template <>
struct action<parent_name> {
    static void apply0(Parsing& state) { state.components.back().parent = state.name; }
};

template <>
struct action<component_opening> {
    static void apply0(Parsing& state) {
        const Word& name = state.components.back().name;
        state.open.push_back({fmt::format("component \"{}\"", name.text), name.where.line});
    }
};

struct close_bracket {
    static void apply0(Parsing& state) { state.open.pop_back(); }
};
template <>
struct action<component_closing> : close_bracket {};

template <>
struct action<component_help> {
    static void apply0(Parsing& state) {
        std::string& help = state.components.back().help;
        if (!help.empty()) {
            fail_at(position(state.source.file(), state.text.where), "component \"{}\" has a help text already",
                    state.components.back().name.text);
        }
        help = std::move(state.text.text);
    }
};

template <>
struct action<type_name> {
    static void apply0(Parsing& state) {
        const auto type = type_named(state.name.text);
        if (!type) refuse(state);
        state.components.back().variables.push_back({type, {}, {}});
    }

    [[noreturn]] static void refuse(Parsing& state) {
        const TextPosition where = position(state.source.file(), state.name.where);
        if (state.name.text == "component") {
            fail_at(where, "expected {}, found \"component\"; the '{{' of {} in line {} is not closed",
                    component_closing::expected, state.open.back().what, state.open.back().line);
        }
        fail_at(where, "unknown type \"{}\"{}", state.name.text, suggestion(state.name.text, body_keywords));
    }
};

template <>
struct action<variable_name> {
    static void apply0(Parsing& state) { state.components.back().variables.back().name = state.name; }
};

template <>
struct action<modified_name> {
    static void apply0(Parsing& state) { state.components.back().variables.push_back({std::nullopt, state.name, {}}); }
};

template <>
struct action<properties_opening> {
    static void apply0(Parsing& state) {
        const Word& name = state.components.back().variables.back().name;
        state.open.push_back({fmt::format("variable \"{}\"", name.text), name.where.line});
    }
};

template <>
struct action<properties_closing> {
    static void apply0(Parsing& state) {
        state.components.back().variables.back().properties = std::exchange(state.settings, {});
        state.open.pop_back();
    }
};

// -- of techniques

template <TechniqueStatement::Kind kind>
struct begin_statement {
    template <typename Input>
    static void apply(const Input& in, Parsing& state) {
        const auto offset = static_cast<std::size_t>(in.begin() - state.source.text().data());
        state.statements.push_back({kind, state.source.place(offset), {}, {}, {}});
    }
};
template <>
struct action<include_word> : begin_statement<TechniqueStatement::Kind::include> {};
template <>
struct action<pass_word> : begin_statement<TechniqueStatement::Kind::pass> {};
template <>
struct action<change_word> : begin_statement<TechniqueStatement::Kind::modify> {};

template <>
struct action<technique_help> {
    static void apply0(Parsing& state) {
        const Place where = state.text.where;
        state.statements.push_back({TechniqueStatement::Kind::help, where, std::move(state.text), {}, {}});
    }
};

template <>
struct action<include_name> {
    static void apply0(Parsing& state) { state.statements.back().subject = std::move(state.text); }
};

struct name_subject {
    static void apply0(Parsing& state) { state.statements.back().subject = state.name; }
};
template <>
struct action<pass_component> : name_subject {};
template <>
struct action<changed_pass> : name_subject {};

template <>
struct action<pass_name> {
    static void apply0(Parsing& state) { state.statements.back().name = state.name; }
};

template <>
struct action<values_opening> {
    static void apply0(Parsing& state) {
        const TechniqueStatement& pass = state.statements.back();
        state.open.push_back({fmt::format("pass \"{}\"", pass.name.value_or(pass.subject).text), pass.where.line});
    }
};

template <>
struct action<values_closing> {
    static void apply0(Parsing& state) {
        state.statements.back().settings = std::exchange(state.settings, {});
        state.open.pop_back();
    }
};

template <typename File>
Parsing parse(const std::string& file, std::string_view text) {
    Parsing state{SourceText(file, text), 0, {}, {}, 0, {}, {}, {}, {}};
    state.next = state.source.begin();
    const std::string_view body = text.substr(state.source.begin());
    peg::memory_input<peg::tracking_mode::lazy> input(body.data(), body.data() + body.size(), file);
    peg::parse<File, action, control>(input, state);
    return state;
}

}  // namespace

std::vector<ComponentStatement> parse_components(const std::string& file, std::string_view text) {
    return parse<component_file>(file, text).components;
}

std::vector<TechniqueStatement> parse_technique(const std::string& file, std::string_view text) {
    return parse<technique_file>(file, text).statements;
}

}  // namespace croquis::framework
