// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Processes end as they are told, their words come back, and one that is left running is waited for.

#include "testbed/base/process.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <string>

namespace testbed {
namespace {

std::span<const std::byte> BytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(Process, TellsItsExitCodeAndItsWords) {
    const MemoryFile output, errors;
    Process process;
    ASSERT_FALSE(process.Start({"sh", "-c", "echo \"$1\"; echo wrong >&2; exit 7", "sh", "it's $HOME"},
                               {.output = output.Get(), .errors = errors.Get()}));
    EXPECT_TRUE(process.IsRunning());
    const ProcessEnd end = process.Wait();
    EXPECT_FALSE(process.IsRunning());
    EXPECT_FALSE(end.IsGood());
    EXPECT_EQ(end.GetExitCode(), 7);
    EXPECT_EQ(end.GetSignal(), 0);
    EXPECT_EQ(output.Read(), "it's $HOME\n") << "no shell reads the words";
    EXPECT_EQ(errors.Read(), "wrong\n");
}

TEST(Process, ReadsItsInput) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    Descriptor own(ends[0]), theirs(ends[1]);
    const MemoryFile output;
    Process process;
    ASSERT_FALSE(process.Start({"cat"}, {.input = theirs.Get(), .output = output.Get()}));
    theirs.Close();
    const std::string text(300000, 'x');
    EXPECT_TRUE(WriteAll(own.Get(), BytesOf(text)));
    own.Close();
    EXPECT_TRUE(process.Wait().IsGood());
    EXPECT_EQ(output.Read(), text);
}

TEST(Process, AReaderThatHasGoneIsNoSignal) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    const Descriptor own(ends[0]);
    Descriptor(ends[1]).Close();
    EXPECT_FALSE(WriteAll(own.Get(), BytesOf("x")));
}

TEST(Process, AProgramThatIsNotThereSaysSo) {
    Process process;
    EXPECT_EQ(process.Start({"no-such-program-at-all"}, {}), std::errc::no_such_file_or_directory);
    EXPECT_FALSE(process.IsRunning());
    process.Kill();  // nothing to kill
    EXPECT_FALSE(IsInstalled("no-such-program-at-all"));
    EXPECT_TRUE(IsInstalled("sh"));
}

TEST(Process, AForkedCopyEndsWithWhatItReturns) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const Descriptor in(ends[0]);
    Descriptor out(ends[1]);
    Process process;
    ASSERT_FALSE(process.Fork([&] { return WriteAll(out.Get(), BytesOf("from the copy")) ? 5 : 6; }));
    out.Close();
    EXPECT_EQ(ReadAll(in.Get()), "from the copy");
    EXPECT_EQ(process.Wait().GetExitCode(), 5);
}

TEST(Process, OneThatEndsIsSeenAndOneThatHangsCanBeKilled) {
    Process quick, hanging;
    ASSERT_FALSE(hanging.Start({"sleep", "1000"}, {}));
    ASSERT_FALSE(quick.Start({"true"}, {}));
    const Process* both[] = {&hanging, &quick};
    Process::WaitForAny(both, std::nullopt);
    const std::optional<ProcessEnd> end = quick.Poll();
    ASSERT_TRUE(end);
    EXPECT_TRUE(end->IsGood());
    EXPECT_FALSE(hanging.Poll());
    Process::WaitForAny(std::span(both).first(1), std::chrono::milliseconds(1));
    EXPECT_FALSE(hanging.Poll()) << "the time was over";
    hanging.Kill();
    Process moved = std::move(hanging);
    const ProcessEnd killed = moved.Wait();
    EXPECT_EQ(killed.GetSignal(), SIGKILL);
    EXPECT_EQ(killed.GetExitCode(), -1);
}

}  // namespace
}  // namespace testbed
