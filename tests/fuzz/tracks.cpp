// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Damaged tracks, most with right checksums of their records. Laws: opening ends with a track or a FileError. Every
// step of a track that was opened can be read. Every scene taken from it is one that can be written and read again.

#include <cstring>
#include <string>
#include <vector>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/capture/scree_capture_format.h"
#include "testbed/input/scene_file.h"
#include "testbed/input/track_file.h"
#include "tests/fuzz/input.h"

namespace fuzz {
namespace {

constexpr size_t magicSize = 8, headSize = 8;

/// The payloads of the first records of a track.
std::vector<std::string> SoundRecords() {
    const std::string bytes = testbed::ReadText(SCREE_SOURCE_DIR "/tests/own_repository/levels/shot.track", "");
    constexpr size_t mostRecords = 4;
    std::vector<std::string> records;
    for (size_t at = magicSize; at < bytes.size() && records.size() < mostRecords;) {
        uint32_t size = 0;
        std::memcpy(&size, bytes.data() + at, sizeof size);
        records.push_back(bytes.substr(at + headSize, size));
        at += headSize + size;
    }
    return records;
}

void Damage(Input& input, std::string& bytes) {
    if (bytes.empty()) return;
    const size_t at = input.Word() % bytes.size();
    switch (input.Choose(5)) {
        case 0:
            bytes.erase(at, 1 + input.Byte() % 40);
            break;
        case 1:
            bytes.insert(at, bytes.substr(at / 2, 1 + input.Byte() % 60));
            break;
        case 2: {
            const float number = input.Number();
            if (at + sizeof number <= bytes.size()) std::memcpy(bytes.data() + at, &number, sizeof number);
            break;
        }
        default:
            bytes[at] = static_cast<char>(input.Byte());
    }
}

std::string Join(const std::vector<std::string>& records) {
    namespace format = scree_capture::detail;
    format::Bytes bytes(format::trackMagic, format::trackMagic + magicSize);
    for (const std::string& record : records) {
        format::PutLittle32(bytes, static_cast<uint32_t>(record.size()));
        format::PutLittle32(bytes,
                            format::Crc32::Of(reinterpret_cast<const unsigned char*>(record.data()), record.size()));
        bytes.insert(bytes.end(), record.begin(), record.end());
    }
    return {bytes.begin(), bytes.end()};
}

void CheckScene(testbed::TrackFile& track, int step) {
    scenes::Scene scene;
    try {
        scene = track.SceneAt(step);
    } catch (const testbed::FileError&) {
        return;
    }
    const std::string text = testbed::WriteScene(scene);
    Demand(testbed::WriteScene(testbed::ReadScene(text, "taken.scene.json")) == text, "a scene of a track is sound");
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const std::vector<std::string> sound = fuzz::SoundRecords();
    fuzz::Demand(sound.size() > 1, "there is a track to damage");
    fuzz::Input input(data, size);
    std::vector<std::string> records = sound;
    constexpr int mostEdits = 6;
    for (int i = 0; i < mostEdits && !input.IsEmpty(); ++i) {
        fuzz::Damage(input, records[static_cast<size_t>(input.Choose(static_cast<int>(records.size())))]);
    }
    std::string bytes = fuzz::Join(records);
    if (input.Choose(8) == 7) fuzz::Damage(input, bytes);  // the frame itself
    try {
        testbed::TrackFile track(bytes, "damaged.track");
        for (const int step : track.GetSteps()) static_cast<void>(track.Read(step));
        fuzz::CheckScene(track, 0);
        fuzz::CheckScene(track, track.GetLastStep());
    } catch (const testbed::FileError&) {
    }
    return 0;
}
