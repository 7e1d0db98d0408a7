// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Contacts, joints and trees of a session as the bytes that timeline_data.js decodes.

#pragma once

#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "testbed/jobs/timeline/byte_stream.h"
#include "testbed/jobs/timeline/motion_data.h"

namespace testbed {

/// Contacts that touch. Per step it holds how many. Of each contact: the indices of both bodies, points + 4 if it is a
/// sensor's, and the direction of the normal in 2^-16 of a turn. Of each point: place from body A in units of the grid,
/// impulse and separation.
class ContactData {
public:
    void Add(const Snapshot& snapshot, const Grid& grid, const MotionData& motion);
    [[nodiscard]] const ByteStream& GetStream() const { return m_stream; }

private:
    ByteStream m_stream;
};

/// Joints get numbers as they come. Per step: how many are there, and of each by growing number: how many are left out
/// before it, and the length between its anchors.
class JointData {
public:
    void Add(const Snapshot& snapshot);
    [[nodiscard]] const ByteStream& GetStream() const { return m_stream; }
    /// By number: bodies, type, anchors in their coordinates.
    [[nodiscard]] nlohmann::ordered_json GetRows() const;

private:
    struct Row {
        int a = 0, b = 0;
        scenes::JointType type = scenes::JointType::revolute;
        Vec2 anchorA{}, anchorB{};
    };
    ByteStream m_stream;
    std::vector<Row> m_rows;
    /// Numbers of those with these bodies and this type, in the order in which they are captured.
    std::map<std::array<int, 3>, std::vector<int>> m_numbers;
};

/// A tree: how many inner nodes it has, and of each its level and its box in units of the grid.
[[nodiscard]] ByteStream PutNodes(const Snapshot& snapshot, const Grid& grid);

}  // namespace testbed
