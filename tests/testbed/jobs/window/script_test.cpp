// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Scripts of input: what each line becomes, and what is said about a line that cannot be meant.

#include "testbed/jobs/window/script.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace testbed {
namespace {

using Kind = InputEvent::Kind;

std::string ProblemOf(std::string_view text) {
    try {
        (void)ParseScript(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

std::string ProblemOfPlaying(std::string_view text) {
    ScriptPlayer player(ParseScript(text));
    try {
        (void)player.Play(0, {}, {});
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Script, PlaysEachLineInItsFrame) {
    ScriptPlayer player(ParseScript("# a comment\n0 move 10 20\n\n0 press   # left\n2 key p\n3 dump a.json\n"));
    EXPECT_EQ(player.GetLastFrame(), 4);
    const ScriptFrame first = player.Play(0, {}, {});
    ASSERT_EQ(first.events.size(), 2u);
    EXPECT_EQ(first.events[0].kind, Kind::move);
    EXPECT_EQ(first.events[0].x, 10);
    EXPECT_EQ(first.events[0].y, 20);
    EXPECT_EQ(first.events[1].kind, Kind::button);
    EXPECT_TRUE(first.events[1].isDown);
    EXPECT_TRUE(player.Play(1, {}, {}).events.empty());
    const ScriptFrame down = player.Play(2, {}, {});
    ASSERT_EQ(down.events.size(), 1u);
    EXPECT_EQ(down.events[0].code, 'P');
    EXPECT_TRUE(down.events[0].isDown);
    const ScriptFrame up = player.Play(3, {}, {});
    ASSERT_EQ(up.events.size(), 1u);
    EXPECT_EQ(up.events[0].code, 'P');
    EXPECT_FALSE(up.events[0].isDown) << "a key goes up in the next frame";
    ASSERT_EQ(up.outputs.size(), 1u);
    EXPECT_EQ(up.outputs[0].path, "a.json");
    EXPECT_FALSE(up.outputs[0].isPicture);
}

TEST(Script, PointsAtWidgetsAndTypes) {
    Items items;
    items["size"] = {100, 10, 200, 30};
    ScriptPlayer player(
        ParseScript("0 move item size\n0 move item size 0.25\n0 text ab c\n0 scroll -2\n0 click right"));
    const ScriptFrame frame = player.Play(0, {}, items);
    ASSERT_EQ(frame.events.size(), 8u);
    EXPECT_EQ(frame.events[0].x, 150);
    EXPECT_EQ(frame.events[0].y, 20);
    EXPECT_EQ(frame.events[1].x, 125);
    EXPECT_EQ(frame.events[4].kind, Kind::text);
    EXPECT_EQ(frame.events[4].code, ' ');
    EXPECT_EQ(frame.events[6].y, -2);
    EXPECT_EQ(frame.events[7].code, 1);
    EXPECT_FALSE(player.Play(1, {}, items).events.at(0).isDown);
}

TEST(Script, SaysWhichLineIsWrongAndWhy) {
    EXPECT_NE(ProblemOf("0 move 1 1\nmove 3 3").find("line 2: begin it with the number of a frame"), std::string::npos);
    EXPECT_NE(ProblemOf("5 key p\n4 key p").find("line 2: its frame comes before"), std::string::npos);
    EXPECT_NE(ProblemOf("0 jump 3").find("line 1: unknown event 'jump': use text, move"), std::string::npos);
    EXPECT_NE(ProblemOfPlaying("0 key hyper").find("unknown key 'hyper': use a character, or space"),
              std::string::npos);
    EXPECT_NE(ProblemOfPlaying("0 press thumb").find("use left, right or middle"), std::string::npos);
    EXPECT_NE(ProblemOfPlaying("0 move 1 up").find("needs a number as word 2"), std::string::npos);
    EXPECT_NE(ProblemOfPlaying("0 move item nothing").find("no item 'nothing'"), std::string::npos);
    EXPECT_NE(ProblemOfPlaying("0 move world scree 1 2").find("pane 'scree' is not shown"), std::string::npos);
    EXPECT_NE(ProblemOfPlaying("0 dump").find("the name of one file"), std::string::npos);
}

}  // namespace
}  // namespace testbed
