// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of expression.h: a parser by recursive descent into a program for a stack.

#include "testbed/moments/expression.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "testbed/base/errors.h"
#include "testbed/base/nearest.h"
#include "testbed/base/text.h"

namespace testbed {

namespace {

using Action = Expression::Action;
using Instruction = Expression::Instruction;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// Deeper nesting is a mistake, and would cost the parser its stack.
constexpr int mostNested = 100;
constexpr std::size_t mostCharacters = 10'000;

enum class Kind { end, number, word, text, symbol };

struct Token {
    Kind kind = Kind::end;
    std::string_view text{};  ///< as written; of a text: what stands between the quotes
    std::size_t at = 0;       ///< of its first character
    double number = 0;
    std::string meant{};  ///< of a text: without the backslashes of escapes
};

[[noreturn]] void Refuse(std::size_t at, std::string_view what, std::string_view problem) {
    throw UsageError(
        fmt::format("character {}{}: {}", at + 1, what.empty() ? "" : fmt::format(", '{}'", what), problem));
}

bool IsDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Words, numbers, texts and symbols of an expression, one after the other.
class Scanner {
public:
    explicit Scanner(std::string_view text) : m_text(text) {}

    Token Next() {
        while (m_at < m_text.size() && std::isspace(static_cast<unsigned char>(m_text[m_at])) != 0) ++m_at;
        if (m_at == m_text.size()) return {Kind::end, {}, m_at};
        const char c = m_text[m_at];
        if (c == '"' || c == '\'') return TakeText(c);
        if (IsDigit(c) || (c == '.' && m_at + 1 < m_text.size() && IsDigit(m_text[m_at + 1]))) return TakeNumber();
        if (IsLetter(c)) {
            return Take(Kind::word, CountWhile(m_at, [](char d) { return IsLetter(d) || IsDigit(d); }));
        }
        for (const std::string_view symbol : {"<=", ">=", "==", "!=", "&&", "||"}) {
            if (m_text.substr(m_at).starts_with(symbol)) return Take(Kind::symbol, symbol.size());
        }
        if (std::string_view("<>!()+-*/.,").find(c) != std::string_view::npos) return Take(Kind::symbol, 1);
        if (c == '=') Refuse(m_at, "=", "a comparison for equality is written ==");
        // A letter of another alphabet is several bytes.
        const std::size_t size =
            1 + CountWhile(m_at + 1, [](char d) { return (static_cast<unsigned char>(d) & 0xC0) == 0x80; });
        Refuse(m_at, m_text.substr(m_at, size), "this means nothing here");
    }

private:
    template <typename Test>
    [[nodiscard]] std::size_t CountWhile(std::size_t from, Test test) const {
        std::size_t end = from;
        while (end < m_text.size() && test(m_text[end])) ++end;
        return end - from;
    }
    Token Take(Kind kind, std::size_t size) {
        const Token token{kind, m_text.substr(m_at, size), m_at};
        m_at += size;
        return token;
    }
    Token TakeText(char quote) {
        Token token{.kind = Kind::text, .at = m_at};
        std::size_t end = m_at + 1;
        for (; end < m_text.size() && m_text[end] != quote; ++end) {
            if (m_text[end] == '\\') TakeEscape(end);
            if (end < m_text.size()) token.meant += m_text[end];
        }
        if (end >= m_text.size()) Refuse(m_at, {}, fmt::format("the closing {} is missing", quote));
        token.text = m_text.substr(m_at + 1, end - m_at - 1);
        m_at = end + 1;
        return token;
    }
    /// From a backslash to the character that it makes an ordinary one.
    void TakeEscape(std::size_t& at) const {
        ++at;
        if (at == m_text.size() || std::string_view("\"'\\").find(m_text[at]) != std::string_view::npos) return;
        Refuse(at - 1, "\\", "a backslash in a name is written twice; before a quote it makes that part of the name");
    }
    Token TakeNumber() {
        std::size_t size = CountWhile(m_at, [](char c) { return IsDigit(c) || c == '.'; });
        const std::size_t e = m_at + size;
        if (e < m_text.size() && (m_text[e] == 'e' || m_text[e] == 'E')) {
            std::size_t digits = e + 1;
            if (digits < m_text.size() && (m_text[digits] == '-' || m_text[digits] == '+')) ++digits;
            if (const std::size_t count = CountWhile(digits, IsDigit); count > 0) size = digits + count - m_at;
        }
        Token token = Take(Kind::number, size);
        const Parsed<double> number = ParseNumber<double>(token.text);
        if (!number) Refuse(token.at, token.text, number.problem);
        token.number = *number;
        return token;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
};

struct NamedAction {
    std::string_view name;
    Action action;
    bool isTruth = false;
};
constexpr std::array fields{NamedAction{"x", Action::x},
                            NamedAction{"y", Action::y},
                            NamedAction{"angle", Action::angle},
                            NamedAction{"vx", Action::vx},
                            NamedAction{"vy", Action::vy},
                            NamedAction{"speed", Action::speed},
                            NamedAction{"spin", Action::spin},
                            NamedAction{"left", Action::left},
                            NamedAction{"bottom", Action::bottom},
                            NamedAction{"right", Action::right},
                            NamedAction{"top", Action::top},
                            NamedAction{"awake", Action::awake, true},
                            NamedAction{"there", Action::there, true}};
constexpr std::array stepWords{NamedAction{"step", Action::step}, NamedAction{"time", Action::time},
                               NamedAction{"bodies", Action::bodies}, NamedAction{"awake", Action::awakeBodies}};
constexpr std::array comparisons{NamedAction{"<", Action::less},    NamedAction{"<=", Action::lessEqual},
                                 NamedAction{">", Action::greater}, NamedAction{">=", Action::greaterEqual},
                                 NamedAction{"==", Action::equal},  NamedAction{"!=", Action::unequal}};
constexpr std::array functions{NamedAction{"abs", Action::absolute}, NamedAction{"min", Action::least},
                               NamedAction{"max", Action::largest}};
/// All words that can begin a value, for messages.
constexpr std::array<std::string_view, 11> valueWords{"body",   "contacts", "depth", "impulse", "step", "time",
                                                      "bodies", "awake",    "abs",   "min",     "max"};

template <std::size_t size>
const NamedAction* Find(const std::array<NamedAction, size>& all, std::string_view name) {
    const auto found = std::ranges::find(all, name, &NamedAction::name);
    return found == all.end() ? nullptr : &*found;
}

/// What a part of an expression is: something that holds or not, or a number.
enum class Type { truth, number };

class Parser {
public:
    Parser(std::string_view text, std::span<const std::string> names) : m_scanner(text), m_names(names) {
        m_token = m_scanner.Next();
    }

    void ParseAll() {
        if (m_token.kind == Kind::end) {
            Refuse(0, {}, "there is no condition; give one like body(\"player\").y < -5");
        }
        const Token first = m_token;
        WantTruth(first, ParseOr());
        if (m_token.kind != Kind::end) RefuseToken("and or or is missing before this");
    }

    std::vector<Instruction> program;
    std::vector<int> bodies;

private:
    [[noreturn]] void RefuseToken(std::string_view problem) const {
        if (m_token.kind == Kind::end) Refuse(m_token.at, {}, fmt::format("the end is too early: {}", problem));
        Refuse(m_token.at, m_token.text, problem);
    }
    static void WantTruth(const Token& first, Type type) {
        if (type != Type::truth) {
            Refuse(first.at, first.text, "this is a number, where something that holds or not is wanted: compare it");
        }
    }
    static void WantNumber(const Token& first, Type type) {
        if (type != Type::number) Refuse(first.at, first.text, "this holds or not, where a number is wanted");
    }

    [[nodiscard]] bool Is(std::string_view text) const {
        return (m_token.kind == Kind::symbol || m_token.kind == Kind::word) && m_token.text == text;
    }
    bool TakeIf(std::string_view text) {
        if (!Is(text)) return false;
        m_token = m_scanner.Next();
        return true;
    }
    void Want(std::string_view text) {
        if (!TakeIf(text)) RefuseToken(fmt::format("'{}' is missing here", text));
    }
    void Emit(Action action, int a = 0, int b = 0, double number = 0) { program.push_back({action, a, b, number}); }

    /// Counts how deep the parser is in itself.
    class Depth {
    public:
        explicit Depth(Parser& parser) : m_parser(parser) {
            if (++m_parser.m_depth > mostNested) m_parser.RefuseToken("too many parts lie within each other");
        }
        ~Depth() { --m_parser.m_depth; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;

    private:
        Parser& m_parser;
    };

    Type ParseOr() {
        return ParseJoined(Action::either, "or", "||", [this] { return ParseAnd(); });
    }
    Type ParseAnd() {
        return ParseJoined(Action::both, "and", "&&", [this] { return ParseNot(); });
    }
    template <typename Part>
    Type ParseJoined(Action action, std::string_view word, std::string_view symbol, Part part) {
        const Token first = m_token;
        const Type type = part();
        while (Is(word) || Is(symbol)) {
            WantTruth(first, type);
            m_token = m_scanner.Next();
            const Token second = m_token;
            WantTruth(second, part());
            Emit(action);
        }
        return type;
    }
    Type ParseNot() {
        const Depth depth(*this);
        if (!TakeIf("not") && !TakeIf("!")) return ParseComparison();
        const Token first = m_token;
        WantTruth(first, ParseNot());
        Emit(Action::invert);
        return Type::truth;
    }
    Type ParseComparison() {
        const Token first = m_token;
        const Type type = ParseSum();
        const NamedAction* comparison = m_token.kind == Kind::symbol ? Find(comparisons, m_token.text) : nullptr;
        if (comparison == nullptr) return type;
        WantNumber(first, type);
        m_token = m_scanner.Next();
        const Token second = m_token;
        WantNumber(second, ParseSum());
        Emit(comparison->action);
        if (m_token.kind == Kind::symbol && Find(comparisons, m_token.text) != nullptr) {
            RefuseToken("a comparison has two sides; join two of them by and");
        }
        return Type::truth;
    }
    Type ParseSum() {
        return ParseChain("+", Action::add, "-", Action::subtract, [this] { return ParseProduct(); });
    }
    Type ParseProduct() {
        return ParseChain("*", Action::multiply, "/", Action::divide, [this] { return ParseUnary(); });
    }
    template <typename Part>
    Type ParseChain(std::string_view one, Action oneAction, std::string_view other, Action otherAction, Part part) {
        const Token first = m_token;
        const Type type = part();
        while (Is(one) || Is(other)) {
            WantNumber(first, type);
            const Action action = Is(one) ? oneAction : otherAction;
            m_token = m_scanner.Next();
            const Token second = m_token;
            WantNumber(second, part());
            Emit(action);
        }
        return type;
    }
    Type ParseUnary() {
        const Depth depth(*this);
        if (!TakeIf("-")) return ParseValue();
        const Token first = m_token;
        WantNumber(first, ParseUnary());
        Emit(Action::negate);
        return Type::number;
    }
    Type ParseValue() {
        const Token first = m_token;
        if (TakeIf("(")) {
            const Type type = ParseOr();
            Want(")");
            return type;
        }
        if (first.kind == Kind::number) {
            m_token = m_scanner.Next();
            Emit(Action::number, 0, 0, first.number);
            return Type::number;
        }
        if (first.kind != Kind::word) RefuseToken("a value is missing here");
        m_token = m_scanner.Next();
        if (first.text == "body") return ParseField();
        if (first.text == "contacts") return ParseContacts();
        if (first.text == "depth") return ParseBetween(Action::depth);
        if (first.text == "impulse") return ParseBetween(Action::impulse);
        if (const NamedAction* function = Find(functions, first.text)) return ParseFunction(*function);
        if (const NamedAction* word = Find(stepWords, first.text)) {
            Emit(word->action);
            return Type::number;
        }
        Refuse(first.at, first.text, DescribeUnknown("value", first.text, valueWords));
    }
    Type ParseField() {
        Want("(");
        const int body = ParseBody();
        Want(")");
        Want(".");
        const NamedAction* field = m_token.kind == Kind::word ? Find(fields, m_token.text) : nullptr;
        if (field == nullptr) {
            std::vector<std::string_view> known;
            for (const NamedAction& one : fields) known.push_back(one.name);
            RefuseToken(DescribeUnknown("field of a body", m_token.text, known));
        }
        m_token = m_scanner.Next();
        Emit(field->action, body);
        return field->isTruth ? Type::truth : Type::number;
    }
    Type ParseContacts() {
        Want("(");
        if (TakeIf(")")) {
            Emit(Action::contacts);
            return Type::number;
        }
        const int a = ParseBody();
        if (TakeIf(")")) {
            Emit(Action::contactsOf, a);
            return Type::number;
        }
        Want(",");
        const int b = ParseBody();
        Want(")");
        Emit(Action::contactsBetween, a, b);
        return Type::number;
    }
    Type ParseBetween(Action action) {
        Want("(");
        const int a = ParseBody();
        Want(",");
        const int b = ParseBody();
        Want(")");
        Emit(action, a, b);
        return Type::number;
    }
    Type ParseFunction(const NamedAction& function) {
        Want("(");
        ParseArgument();
        if (function.action != Action::absolute) {
            Want(",");
            ParseArgument();
        }
        Want(")");
        Emit(function.action);
        return Type::number;
    }
    void ParseArgument() {
        const Token first = m_token;
        WantNumber(first, ParseSum());
    }
    /// A name in quotes or an index.
    int ParseBody() {
        const Token token = m_token;
        if (token.kind != Kind::text && token.kind != Kind::number) {
            RefuseToken("a body is missing here: its name in quotes, or its index");
        }
        m_token = m_scanner.Next();
        const int index = token.kind == Kind::text ? IndexOfName(token) : IndexOfNumber(token);
        if (std::ranges::find(bodies, index) == bodies.end()) bodies.push_back(index);
        return index;
    }
    [[nodiscard]] int IndexOfNumber(const Token& token) const {
        const Parsed<int> index = ParseNumber<int>(token.text);
        if (!index || *index < 0 || *index >= std::ssize(m_names)) {
            Refuse(token.at, token.text,
                   fmt::format("there is no body of that index; they are from 0 to {}", std::ssize(m_names) - 1));
        }
        return *index;
    }
    [[nodiscard]] int IndexOfName(const Token& token) const {
        std::vector<int> found;
        std::vector<std::string_view> known;
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            if (m_names[i].empty()) continue;
            known.emplace_back(m_names[i]);
            if (m_names[i] == token.meant) found.push_back(static_cast<int>(i));
        }
        if (found.size() == 1) return found.front();
        if (found.size() > 1) {
            Refuse(token.at, token.text,
                   fmt::format("{} bodies are called so; give the index of one: {} or {}", found.size(), found[0],
                               found[1]));
        }
        if (known.empty()) {
            Refuse(token.at, token.text, "no body here has a name; give an index without quotes");
        }
        Refuse(token.at, token.text, "no body is called so" + SuggestName(token.text, known));
    }

    Scanner m_scanner;
    std::span<const std::string> m_names;
    Token m_token;
    int m_depth = 0;
};

/// How the height of the stack changes.
int GrowthOf(Action action) {
    if (action < Action::negate) return 1;
    return action <= Action::invert ? 0 : -1;
}

double LengthOf(Vec2 v) { return std::hypot(double{v.x}, double{v.y}); }

const BodyState* BodyIn(const Frame& frame, int index) {
    const int place = frame.placeNow[static_cast<std::size_t>(index)];
    return place < 0 ? nullptr : &frame.now.bodies[static_cast<std::size_t>(place)];
}

/// A side of the box around the fixtures of a body.
double SideOf(const Frame& frame, int index, Action side) {
    const int place = frame.placeNow[static_cast<std::size_t>(index)];
    double found = unknown;
    for (const FixtureState& fixture : frame.now.fixtures) {
        if (fixture.body != place) continue;
        const Box& box = fixture.tight;
        // fmin and fmax leave out what is unknown.
        if (side == Action::left) found = std::fmin(found, double{box.lower.x});
        if (side == Action::bottom) found = std::fmin(found, double{box.lower.y});
        if (side == Action::right) found = std::fmax(found, double{box.upper.x});
        if (side == Action::top) found = std::fmax(found, double{box.upper.y});
    }
    return found;
}

double FieldOf(const Frame& frame, const Instruction& one) {
    const BodyState* body = BodyIn(frame, one.a);
    if (one.action == Action::there) return body != nullptr ? 1.0 : 0.0;
    if (body == nullptr) return one.action == Action::awake ? 0.0 : unknown;
    switch (one.action) {
        case Action::x:
            return body->position.x;
        case Action::y:
            return body->position.y;
        case Action::angle:
            return body->angle;
        case Action::vx:
            return body->linearVelocity.x;
        case Action::vy:
            return body->linearVelocity.y;
        case Action::speed:
            return LengthOf(body->linearVelocity);
        case Action::spin:
            return body->angularVelocity;
        case Action::awake:
            return body->awake ? 1.0 : 0.0;
        default:
            return SideOf(frame, one.a, one.action);
    }
}

/// Over the contacts that touch and belong to the bodies.
double OverContacts(const Frame& frame, const Instruction& one) {
    const auto bodyOf = [&](int fixture) {
        const int place = frame.now.fixtures[static_cast<std::size_t>(fixture)].body;
        return frame.now.bodies[static_cast<std::size_t>(place)].index;
    };
    double count = 0, depth = 0, impulse = 0;
    for (const ContactState& contact : frame.now.contacts) {
        if (!contact.touching) continue;
        const int a = bodyOf(contact.fixtureA), b = bodyOf(contact.fixtureB);
        const bool isIt = one.action == Action::contacts ||
                          (one.action == Action::contactsOf ? a == one.a || b == one.a
                                                            : (a == one.a && b == one.b) || (a == one.b && b == one.a));
        if (!isIt) continue;
        ++count;
        for (int i = 0; i < contact.pointCount; ++i) {
            depth = std::max(depth, -double{contact.separations[i]});
            impulse += double{contact.normalImpulses[i]};
        }
    }
    if (one.action == Action::depth) return depth;
    return one.action == Action::impulse ? impulse : count;
}

double PushedBy(const Frame& frame, const Instruction& one) {
    switch (one.action) {
        case Action::number:
            return one.number;
        case Action::step:
            return frame.now.step;
        case Action::time:
            return frame.time;
        case Action::bodies:
            return static_cast<double>(frame.now.bodies.size());
        case Action::awakeBodies:
            return static_cast<double>(std::ranges::count_if(frame.now.bodies, &BodyState::awake));
        case Action::contacts:
        case Action::contactsOf:
        case Action::contactsBetween:
        case Action::depth:
        case Action::impulse:
            return OverContacts(frame, one);
        default:
            return FieldOf(frame, one);
    }
}

double Join(Action action, double a, double b) {
    switch (action) {
        case Action::add:
            return a + b;
        case Action::subtract:
            return a - b;
        case Action::multiply:
            return a * b;
        case Action::divide:
            return a / b;
        case Action::least:  // with something unknown, unknown
            return std::isnan(a) || a < b ? a : b;
        case Action::largest:
            return std::isnan(a) || a > b ? a : b;
        case Action::less:
            return a < b ? 1.0 : 0.0;
        case Action::lessEqual:
            return a <= b ? 1.0 : 0.0;
        case Action::greater:
            return a > b ? 1.0 : 0.0;
        case Action::greaterEqual:
            return a >= b ? 1.0 : 0.0;
        case Action::equal:
            return a == b ? 1.0 : 0.0;
        case Action::unequal:  // nor does what is unknown differ
            return a < b || a > b ? 1.0 : 0.0;
        case Action::both:
            return a * b;
        default:
            return std::max(a, b);
    }
}

}  // namespace

Expression::Expression(std::string_view text, std::span<const std::string> names) : m_text(text) {
    if (text.size() > mostCharacters) {
        Refuse(mostCharacters, {}, fmt::format("an expression has at most {} characters", mostCharacters));
    }
    Parser parser(m_text, names);
    parser.ParseAll();
    m_program = std::move(parser.program);
    m_bodies = std::move(parser.bodies);
    std::ranges::sort(m_bodies);
    int height = 0;
    for (const Instruction& one : m_program) {
        height += GrowthOf(one.action);
        m_stackSize = std::max(m_stackSize, static_cast<std::size_t>(height));
        if (one.action >= Action::contacts && one.action <= Action::impulse) m_needsContacts = true;
    }
}

bool Expression::Holds(const Frame& frame) const {
    std::vector<double> stack;
    stack.reserve(m_stackSize);
    for (const Instruction& one : m_program) {
        if (one.action < Action::negate) {
            stack.push_back(PushedBy(frame, one));
        } else if (one.action == Action::negate) {
            stack.back() = -stack.back();
        } else if (one.action == Action::absolute) {
            stack.back() = std::abs(stack.back());
        } else if (one.action == Action::invert) {
            stack.back() = 1.0 - stack.back();
        } else {
            const double b = stack.back();
            stack.pop_back();
            stack.back() = Join(one.action, stack.back(), b);
        }
    }
    return stack.back() == 1.0;
}

}  // namespace testbed
