// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Expressions say what the state says, for random trees of them as well, and no text whatever brings the reader down:
// what it refuses, it refuses with the place.

#include "testbed/moments/expression.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "testbed/base/errors.h"
#include "tests/testbed/engines/scene_builder.h"

namespace testbed {
namespace {

/// Three bodies and a contact; the one with index 3 is gone, and the one with index 2 has no number for its place.
class ExpressionTest : public testing::Test {
protected:
    ExpressionTest() {
        const auto body = [](int index, Vec2 position, Vec2 velocity, bool awake) {
            BodyState state{};
            state.index = index;
            state.type = scenes::BodyType::dynamic;
            state.position = position;
            state.linearVelocity = velocity;
            state.angularVelocity = -2.5f;
            state.angle = 0.5f;
            state.awake = awake;
            return state;
        };
        // Places in the snapshot are not the indices.
        m_now.bodies = {body(1, {3.0f, -6.0f}, {3.0f, -4.0f}, true), body(0, {1.0f, 2.0f}, {}, false),
                        body(2, {std::numeric_limits<float>::quiet_NaN(), 1.0f}, {}, true)};
        FixtureState fixture{};
        fixture.body = 0;
        fixture.tight = {{2.5f, -6.5f}, {3.5f, -5.0f}};
        m_now.fixtures.push_back(fixture);
        fixture.body = 1;
        m_now.fixtures.push_back(fixture);
        ContactState contact{};
        contact.fixtureB = 1;
        contact.touching = true;
        contact.pointCount = 2;
        contact.separations[0] = -0.25f;
        contact.normalImpulses[0] = 2.0f;
        contact.normalImpulses[1] = 1.5f;
        m_now.contacts.push_back(contact);
        contact.touching = false;
        m_now.contacts.push_back(contact);
        m_now.step = 90;
    }
    [[nodiscard]] bool Holds(const std::string& text) const {
        return Expression(text, m_names)
            .Holds({.now = m_now,
                    .before = nullptr,
                    .time = 1.5,
                    .placeNow = m_place,
                    .placeBefore = m_place,
                    .scene = m_scene});
    }
    /// What a text is refused with.
    [[nodiscard]] std::string Fault(const std::string& text) const {
        try {
            const Expression expression(text, m_names);
            return {};
        } catch (const UsageError& error) {
            return error.what();
        }
    }
    void ExpectFault(const std::string& text, const std::string& says) const {
        const std::string fault = Fault(text);
        EXPECT_NE(fault.find(says), std::string::npos) << text << "\n" << fault;
    }

    Snapshot m_now;
    scenes::Scene m_scene;
    std::vector<std::string> m_names{"lava", "player", "", "ghost", "crate", "crate", R"(5" \ 'nail')", "\\"};
    std::vector<int> m_place{1, 0, 2, -1, -1, -1, 1, 0};
};

TEST_F(ExpressionTest, SaysWhatTheStateSays) {
    for (const char* text :
         {"body(\"player\").y < -5", "body('player').x == 3", "body(1).speed == 5", "body(1).spin == -2.5",
          "body(1).angle == .5", "body(1).vx + body(1).vy == -1", "body(\"player\").awake", "not body(\"lava\").awake",
          "body(1).left == 2.5 and body(1).bottom == -6.5 and body(1).right == 3.5 && body(1).top == -5",
          "contacts(\"player\", \"lava\") > 0", "contacts(0, 1) == contacts()", "contacts(1) == 1", "contacts(2) == 0",
          "depth(0, 1) == 0.25", "impulse(\"lava\", 1) == 3.5", "step == 90 and time == 1.5",
          "bodies == 3 and awake == 2", "1 + 2 * 3 == 7", "(1 + 2) * 3 == 9", "7 - 2 - 1 == 4", "8 / 4 / 2 == 1",
          "-2 * -3 == 6", "1 - -1 == 2", "abs(body(1).vy) == 4", "min(1, 2) == 1 and max(1, 2) == 2", "1e-3 < 2E+1",
          "1 > 2 or 2 > 1 and 3 > 2", "not 1 > 2 and not (2 > 1 and 1 > 2)", "! 1 > 2 || 1 > 2", "not not 2 >= 2",
          "1 != 2 and 2 <= 2",
          // Index 6 is called 5" \ 'nail', and index 7 is called \.
          R"(body("5\" \\ 'nail'").x == 1)", R"(body('5" \\ \'nail\'').x == 1)",
          R"(body("5\" \\ \'nail\'").x == 1 and body("\\").x == 3)"}) {
        EXPECT_TRUE(Holds(text)) << text;
        EXPECT_FALSE(Holds(fmt::format("not ({})", text))) << text;
    }
}

TEST_F(ExpressionTest, NothingIsTrueOfWhatIsNotThereOrNoNumber) {
    for (const std::string value :
         {"body(\"ghost\").x", "body(2).x", "body(2).left", "0 / 0", "min(body(3).y, 1)", "max(1, body(3).y)"}) {
        for (const char* comparison : {"<", "<=", ">", ">=", "==", "!="}) {
            EXPECT_FALSE(Holds(value + comparison + "0")) << value << comparison;
            EXPECT_FALSE(Holds("0" + (comparison + value))) << comparison << value;
        }
    }
    EXPECT_FALSE(Holds("body(\"ghost\").awake"));
    EXPECT_FALSE(Holds("body(\"ghost\").there"));
    EXPECT_TRUE(Holds("body(2).there"));
}

TEST_F(ExpressionTest, FaultsAreNamedAtTheirPlace) {
    ExpectFault("", "character 1: there is no condition");
    ExpectFault("body(\"playr\").y < 1", "character 6, 'playr': no body is called so; did you mean 'player'?");
    ExpectFault("body(\"crate\").y < 1", "character 6, 'crate': 2 bodies are called so; give the index of one: 4 or 5");
    ExpectFault("body(8).y < 1", "character 6, '8': there is no body of that index; they are from 0 to 7");
    ExpectFault("body(1.5).y < 1", "character 6, '1.5': there is no body");
    ExpectFault("body(1).yy < 1", "character 9, 'yy': unknown field of a body 'yy'; did you mean 'y'?");
    ExpectFault("bdy(1).y < 1", "character 1, 'bdy': unknown value 'bdy'; did you mean 'body'?");
    ExpectFault("body(1).y", "character 1, 'body': this is a number, where something that holds or not is wanted");
    ExpectFault("body(1).awake > 1", "character 1, 'body': this holds or not, where a number is wanted");
    ExpectFault("1 < 2 < 3", "character 7, '<': a comparison has two sides");
    ExpectFault("1 < 2 3 < 4", "character 7, '3': and or or is missing");
    ExpectFault("1 <", "character 4: the end is too early: a value is missing here");
    ExpectFault("(1 < 2", "character 7: the end is too early: ')' is missing");
    ExpectFault("step = 3", "character 6, '=': a comparison for equality is written ==");
    ExpectFault("body(\"player.y < 1", "character 6: the closing \" is missing");
    // Escapes: only of quotes and backslashes, and a quote that one takes does not close.
    ExpectFault(R"(body("pla\yer").y < 1)", "character 10, '\\': a backslash in a name is written twice");
    ExpectFault(R"(body("player\").y < 1)", "character 6: the closing \" is missing");
    ExpectFault(R"(body("player\)", "character 6: the closing \" is missing");
    ExpectFault(R"(body('player\').y < 1)", "character 6: the closing ' is missing");
    ExpectFault(R"(body("5\" nail").y < 1)", R"(character 6, '5\" nail': no body is called so)");
    ExpectFault(R"(body("\"").y < bdy(1).y)", R"(character 6, '\"': no body is called so)");
    ExpectFault(R"(body("\\").y < bdy(1).y)", "character 16, 'bdy': unknown value");
    ExpectFault("step > 1 § 2", "character 10, '§': this means nothing here");
    ExpectFault("step > 1.2.3", "character 8, '1.2.3':");
    ExpectFault(std::string(3000, '(') + "1", "too many parts lie within each other");
    ExpectFault(std::string(3000, '-') + "1 < 2", "too many parts lie within each other");
    ExpectFault(std::string(20'000, ' '), "an expression has at most 10000 characters");
}

/// Random expressions with their values, worked out beside the parser.
class Writer {
public:
    explicit Writer(std::mt19937& random) : m_random(random) {}

    std::pair<std::string, double> Number(int depth) {
        const int kind = Below(depth > 0 ? 7 : 2);
        if (kind == 0) {
            const double value = Below(2000) / 8.0;
            return {fmt::format("{}", value), value};
        }
        if (kind == 1) return {"body(1).vx", 3.0};
        const auto [a, x] = Number(depth - 1);
        if (kind == 2) return {fmt::format("-({})", a), -x};
        const auto [b, y] = Number(depth - 1);
        if (kind == 3) return {fmt::format("({} + {})", a, b), x + y};
        if (kind == 4) return {fmt::format("({}-{})", a, b), x - y};
        if (kind == 5) return {fmt::format("({})*({})", a, b), x * y};
        return {fmt::format("max({}, abs({}))", a, b), std::max(x, std::abs(y))};
    }
    std::pair<std::string, bool> Truth(int depth) {
        const int kind = Below(depth > 0 ? 4 : 1);
        if (kind == 0) {
            const auto [a, x] = Number(3);
            const auto [b, y] = Number(3);
            return Below(2) == 0 ? std::pair{fmt::format("{} < {}", a, b), x < y}
                                 : std::pair{fmt::format("{} >= {}", a, b), x >= y};
        }
        const auto [a, x] = Truth(depth - 1);
        if (kind == 1) return {fmt::format("not ({})", a), !x};
        const auto [b, y] = Truth(depth - 1);
        return kind == 2 ? std::pair{fmt::format("({}) and ({})", a, b), x && y}
                         : std::pair{fmt::format("({}) or ({})", a, b), x || y};
    }

private:
    int Below(int end) { return std::uniform_int_distribution(0, end - 1)(m_random); }
    std::mt19937& m_random;
};

TEST_F(ExpressionTest, RandomExpressionsHoldWhenTheyShould) {
    std::mt19937 random(3);
    Writer writer(random);
    int holding = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto [text, expected] = writer.Truth(4);
        EXPECT_EQ(Holds(text), expected) << text;
        holding += expected ? 1 : 0;
    }
    EXPECT_GT(holding, 500);
    EXPECT_LT(holding, 1500);
}

TEST_F(ExpressionTest, NoTextBringsTheReaderDown) {
    const std::vector<std::string> parts{"body(\"player\")",
                                         ".y",
                                         ".awake",
                                         "contacts(",
                                         "depth(0, 1)",
                                         "(",
                                         ")",
                                         ",",
                                         "<",
                                         ">=",
                                         "==",
                                         "!=",
                                         "and",
                                         "or",
                                         "not",
                                         "!",
                                         "+",
                                         "-",
                                         "*",
                                         "/",
                                         "1",
                                         "2.5",
                                         "1e9",
                                         "\"",
                                         "\\",
                                         R"(body("5\" \\ 'nail'"))",
                                         "step",
                                         "abs",
                                         "min(",
                                         "body",
                                         "0/0",
                                         "§",
                                         "\x01",
                                         "e"};
    std::mt19937 random(4);
    const auto below = [&](std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random); };
    Writer writer(random);
    int read = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string text = i % 2 == 0 ? writer.Truth(2).first : "";
        const std::size_t edits = 1 + below(i % 2 == 0 ? 3 : 12);
        for (std::size_t edit = 0; edit < edits; ++edit) {
            const std::size_t at = below(text.size() + 1);
            const std::size_t kind = i % 2 == 0 ? below(3) : 0;
            if (kind == 0) text.insert(at, " " + parts[below(parts.size())]);
            if (kind == 1 && at < text.size()) text[at] = static_cast<char>(below(256));
            if (kind == 2) text.erase(at, below(4));
        }
        try {
            (void)Holds(text);
            ++read;
        } catch (const UsageError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("character ")) << text << "\n" << error.what();
        }
    }
    EXPECT_GT(read, 100) << "some must still mean something";
}

}  // namespace
}  // namespace testbed
