// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Other processes: programs that are started without a shell, so that no word needs quoting for one, and forked copies
// of this one.
//
//     const MemoryFile words;
//     Process process;
//     const std::error_code error = process.Start({"gnuplot", script}, {.output = words.Get(), .errors = words.Get()});
//     if (!error && process.Wait().IsGood()) …

#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace testbed {

/// A file descriptor that is closed with the object.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int number) : m_number(number) {}
    Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(m_number, other.m_number);
        return *this;
    }
    ~Descriptor() { Close(); }

    void Close();
    [[nodiscard]] int Get() const { return m_number; }
    [[nodiscard]] bool IsOpen() const { return m_number >= 0; }

private:
    int m_number = -1;
};

/// All bytes of `data` into a descriptor; false when it takes no more. A socket whose reader has gone ends no process
/// by a signal.
[[nodiscard]] bool WriteAll(int descriptor, std::span<const std::byte> data);
/// All bytes from here to the end.
[[nodiscard]] std::string ReadAll(int descriptor);

/// A file without a name, for what a process writes.
class MemoryFile {
public:
    MemoryFile();
    [[nodiscard]] int Get() const { return m_file.Get(); }
    /// Everything in it; call it when its writers have ended.
    [[nodiscard]] std::string Read() const;

private:
    Descriptor m_file;
};

/// What a new process reads and writes; −1: the same as this one.
struct ProcessFiles {
    int input = -1, output = -1, errors = -1;
};

/// How a process ended.
struct ProcessEnd {
    int status = 0;  ///< as waitpid tells it

    /// By itself, with 0.
    [[nodiscard]] bool IsGood() const { return status == 0; }
    /// What it returned; −1: a signal ended it.
    [[nodiscard]] int GetExitCode() const;
    /// What ended it; 0: it ended by itself.
    [[nodiscard]] int GetSignal() const;
};

/// A process that this one started. A running one is waited for when the object goes.
class Process {
public:
    Process() = default;
    Process(Process&& other) noexcept : m_id(std::exchange(other.m_id, -1)), m_signal(std::move(other.m_signal)) {}
    Process& operator=(Process&& other) noexcept {
        std::swap(m_id, other.m_id);
        std::swap(m_signal, other.m_signal);
        return *this;
    }
    ~Process();

    /// Runs a program with its arguments: words[0] is a path if it has a slash, else a name on PATH. None runs yet. The
    /// reason if it does not start.
    [[nodiscard]] std::error_code Start(std::vector<std::string> words, const ProcessFiles& files);
    /// Runs `body` in a copy of this process, which ends with what it returns and without exit handlers, for these
    /// belong to the parent. Only for a process of one thread. None runs yet.
    [[nodiscard]] std::error_code Fork(const std::function<int()>& body);

    [[nodiscard]] bool IsRunning() const { return m_id >= 0; }  ///< started, and its end not yet seen
    ProcessEnd Wait();
    /// The end if it has come.
    [[nodiscard]] std::optional<ProcessEnd> Poll();
    void Kill();
    /// Sends it a signal, unless it has ended.
    void Stop(int signal);

    /// Returns when one of these has ended or the time is over, at least one of which runs. No time: without end.
    static void WaitForAny(std::span<const Process* const> processes, std::optional<std::chrono::milliseconds> time);

private:
    pid_t m_id = -1;      ///< −1: none
    Descriptor m_signal;  ///< readable when it has ended
};

/// Whether a program of this name is on PATH.
[[nodiscard]] bool IsInstalled(std::string_view program);

}  // namespace testbed
