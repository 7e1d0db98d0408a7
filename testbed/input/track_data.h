// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What an open track keeps: its bytes, where the steps are in them, and all objects that ever were. Filled by
// track_index.cpp, decoded by track_read.cpp.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbed/input/cbor.h"
#include "testbed/input/track_file.h"

namespace testbed {

/// A record that holds steps.
struct TrackBlock {
    std::size_t payloadAt = 0, payloadSize = 0;  ///< in the file
    std::size_t inflatedSize = 0;                ///< of what it holds, deflated; 0: it is not
    int number = 0;                              ///< of the record, from 1
};

/// Where a step is.
struct TrackEntry {
    int block = 0;
    std::size_t at = 0;  ///< in the block's payload, inflated
    bool isKey = false;
};

/// State of a body as the bits that are predicted from.
struct TrackBits {
    std::uint32_t bits[6] = {};
    bool awake = false;
};

struct TrackFile::Data {
    std::string source;
    std::string bytes;
    TrackInfo info;
    scenes::Scene parts;
    std::vector<TrackBody> bodies;
    std::vector<TrackJoint> joints;
    std::vector<int> steps;
    std::vector<TrackEntry> entries;  ///< of `steps`
    std::vector<TrackBlock> blocks;
    nlohmann::ordered_json user;                      ///< of the scene, without its bodies
    std::map<int, nlohmann::ordered_json> bodyUsers;  ///< by index of a body

    // Where reading stands.
    int openBlock = -1;
    std::vector<std::uint8_t> inflated;  ///< payload of openBlock
    int position = -1;                   ///< index of the step that `state` is of; −1: the start
    std::vector<TrackBits> created, state;
    TrackStep current;

    /// Finds all steps and objects; fills everything above but what is for reading.
    void BuildIndex();
    /// The payload of a block, and a reader at its beginning that names it in messages.
    CborReader Open(int block);
    void PrepareReading();
    /// Makes the state after steps[index] the one of `current`.
    void GoTo(int index);
    [[nodiscard]] scenes::Scene MakeScene(int step) const;

private:
    void Decode(int index, bool isWanted);
    void DecodeBodies(CborReader& reader, ByteSpan packed, bool isKey, double h);
    void SetStart();
};

}  // namespace testbed
