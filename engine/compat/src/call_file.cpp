// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of call_file.h.

#include "call_file.h"

#include <atomic>
#include <cstdlib>
#include <span>
#include <string>

namespace scree::box2d {

namespace {

/// "a/session.recording", 2 → "a/session-2.recording".
std::string NameOf(std::string name, int number) {
    if (number == 1) return name;
    const std::size_t folder = name.find_last_of('/');
    const std::size_t dot = name.find_last_of('.');
    const bool hasEnding = dot != std::string::npos && (folder == std::string::npos || dot > folder + 1);
    return name.insert(hasEnding ? dot : name.size(), '-' + std::to_string(number));
}

}  // namespace

std::unique_ptr<CallFile> CallFile::OpenIfAsked(World& world) {
    static std::atomic<int> count = 0;
    const char* asked = std::getenv("SCREE_RECORD");
    if (asked == nullptr || *asked == '\0') return nullptr;
    const std::string name = NameOf(asked, ++count);
    std::FILE* file = std::fopen(name.c_str(), "wb");
    if (file == nullptr) {
        std::fprintf(stderr, "scree: SCREE_RECORD: cannot write %s; give a file in a folder that is there\n",
                     name.c_str());
        return nullptr;
    }
    return std::unique_ptr<CallFile>(new CallFile(world, file));
}

CallFile::CallFile(World& world, std::FILE* file) : m_world(world), m_file(file) {
    StartRecording(world, m_recorder);
    Write();
}

CallFile::~CallFile() {
    StopRecording(m_world);
    Write();
    std::fclose(m_file);
}

void CallFile::Write() {
    const std::span<const std::byte> rest = m_recorder.GetBytes().subspan(m_written);
    m_written += std::fwrite(rest.data(), 1, rest.size(), m_file);
    std::fflush(m_file);
}

}  // namespace scree::box2d
