// The grammars of descriptors and techniques in PEGTL (seed C, programs 2.1-2.3 and 2.7), for grammar.cpp alone.
// Comments, quoted texts and settings are shared; each file format adds its statements. Nothing nests without bound, so
// parsing does not recurse. A rule that must match says in `expected` what an error calls it; every token is followed
// by `skip`, and the first character of a token decides which it is, so that an error stands at the token's start.
#pragma once

#include <tao/pegtl.hpp>

namespace croquis::framework::grammar_rules {

namespace peg = tao::pegtl;

// ---- Tokens, shared -------------------------------------------------------------------------------------------------

struct line_end : peg::one<'\n', '\r'> {};
struct comment : peg::seq<peg::one<'#'>, peg::star<peg::not_at<line_end>, peg::any>> {};
struct skip : peg::star<peg::sor<peg::one<' ', '\t', '\r', '\n'>, comment>> {};
template <typename Rule>
struct token : peg::seq<Rule, skip> {};

struct word_character : peg::not_one<' ', '\t', '\r', '\n', '#', '{', '}', ';', '"'> {};
struct bare_word : peg::plus<word_character> {};
// A name is followed by what cannot go on a word, or by the colon before a parent.
struct name_shape : peg::seq<peg::identifier, peg::not_at<peg::not_at<peg::one<':'>>, word_character>> {};
struct name_token : token<name_shape> {};
template <char... Letters>
struct keyword : token<peg::seq<peg::string<Letters...>, peg::not_at<word_character>>> {};
struct semicolon : token<peg::one<';'>> {};
struct opening : token<peg::one<'{'>> {};
struct closing : token<peg::one<'}'>> {};
struct end_of_file : peg::eof {};

struct opening_quote : peg::one<'"'> {};
struct closing_quote : peg::one<'"'> {};
struct plain_text : peg::plus<peg::not_one<'"', '\\', '\n', '\r'>> {};
struct escaped : peg::one<'"', '\\'> {};
struct escape : peg::if_must<peg::one<'\\'>, escaped> {};
struct quoted : peg::if_must<opening_quote, peg::star<peg::sor<plain_text, escape>>, closing_quote> {};
struct text_start : peg::at<peg::one<'"'>> {};
struct joined_text : peg::seq<text_start, peg::plus<token<quoted>>> {};

// ---- Settings, shared -----------------------------------------------------------------------------------------------

struct setting_name : name_token {};
struct text_value : joined_text {};
struct value_word : bare_word {};
struct bare_value : peg::plus<token<value_word>> {};
struct value : peg::sor<text_value, bare_value> {
    static constexpr const char* expected = "a value";
};
struct after_value : semicolon {
    static constexpr const char* expected = "';' after the value";
};
struct setting : peg::if_must<setting_name, value, after_value> {};

// ---- Descriptors ----------------------------------------------------------------------------------------------------

struct help_word : keyword<'h', 'e', 'l', 'p'> {};
struct modify_word : keyword<'m', 'o', 'd', 'i', 'f', 'y'> {};
struct help_text : joined_text {
    static constexpr const char* expected = "a help text in double quotes";
};

struct component_word : keyword<'c', 'o', 'm', 'p', 'o', 'n', 'e', 'n', 't'> {};
struct component_name : name_token {
    static constexpr const char* expected = "a name for the component";
};
struct parent_name : name_token {
    static constexpr const char* expected = "the name of the component it inherits from";
};
struct parent : peg::if_must<token<peg::one<':'>>, parent_name> {};
struct component_opening : opening {
    static constexpr const char* expected = "'{' after the component's name";
};
struct component_closing : closing {
    static constexpr const char* expected = "a type, \"modify\", \"help\" or '}'";
};

struct component_help : peg::if_must<help_word, help_text, after_value> {};
struct type_name : name_token {};
struct variable_name : name_token {
    static constexpr const char* expected = "a name for the variable";
};
struct properties_opening : opening {};
struct properties_closing : closing {
    static constexpr const char* expected = "a property or '}'";
};
struct properties : peg::if_must<properties_opening, peg::star<setting>, properties_closing> {
    static constexpr const char* expected = "'{' after the variable's name";
};
struct variable_end : peg::sor<semicolon, peg::seq<properties, peg::opt<semicolon>>> {
    static constexpr const char* expected = "';' or '{' after the variable's name";
};
struct variable : peg::if_must<type_name, variable_name, variable_end> {};
struct modified_name : name_token {
    static constexpr const char* expected = "the name of the variable to modify";
};
struct modification : peg::if_must<modify_word, modified_name, properties, peg::opt<semicolon>> {};

struct component : peg::if_must<component_word, component_name, peg::opt<parent>, component_opening,
                                peg::star<peg::sor<component_help, modification, variable>>, component_closing,
                                peg::opt<semicolon>> {};
struct end_of_components : end_of_file {
    static constexpr const char* expected = "\"component\"";
};
struct component_file : peg::seq<skip, peg::star<component>, peg::must<end_of_components>> {};

// ---- Techniques -----------------------------------------------------------------------------------------------------

struct technique_help : peg::if_must<help_word, help_text, after_value> {};
struct include_word : keyword<'i', 'n', 'c', 'l', 'u', 'd', 'e'> {};
struct include_name : joined_text {
    static constexpr const char* expected = "the name of a technique in double quotes";
};
struct include : peg::if_must<include_word, include_name, after_value> {};

struct values_opening : opening {};
struct values_closing : closing {
    static constexpr const char* expected = "a variable or '}'";
};
struct values : peg::if_must<values_opening, peg::star<setting>, values_closing> {
    static constexpr const char* expected = "'{' after the pass's name";
};
struct pass_word : keyword<'p', 'a', 's', 's'> {};
struct pass_component : name_token {
    static constexpr const char* expected = "the name of the pass's component";
};
struct pass_name : name_token {};
struct pass_end : peg::sor<semicolon, peg::seq<values, peg::opt<semicolon>>> {
    static constexpr const char* expected = "'{' after the pass's name";
};
struct after_component : peg::sor<peg::if_must<pass_name, pass_end>, pass_end> {
    static constexpr const char* expected = "a name for the pass or '{'";
};
struct pass : peg::if_must<pass_word, pass_component, after_component> {};
struct changed_pass : name_token {
    static constexpr const char* expected = "the name of the pass to modify";
};
struct change_word : modify_word {};
struct change : peg::if_must<change_word, changed_pass, values, peg::opt<semicolon>> {};

struct end_of_technique : end_of_file {
    static constexpr const char* expected = "\"pass\", \"include\", \"modify\" or \"help\"";
};
struct technique_file
    : peg::seq<skip, peg::star<peg::sor<technique_help, include, pass, change>>, peg::must<end_of_technique>> {};

}  // namespace croquis::framework::grammar_rules
