// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The bodies of a session as a page draws and tells them: names, shapes, masses.

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/scene.h"
#include "testbed/engines/snapshot.h"

namespace testbed {

/// Bodies that a page can hold.
inline constexpr std::size_t mostTimelineBodies = 100'000;

/// About the centre of mass; 0 for what forces do not move.
struct BodyMass {
    double mass = 0, inertia = 0;  ///< kg, kg m²
};

/// By index of a body. Shapes come with the first snapshot that has the body.
class BodyRows {
public:
    /// `names` by index. Throws UsageError for more bodies than a page holds.
    BodyRows(const scenes::Scene& scene, const std::vector<std::string>& names);
    void Note(const Snapshot& snapshot);
    [[nodiscard]] const nlohmann::ordered_json& GetRows() const { return m_rows; }
    [[nodiscard]] const BodyMass& GetMass(int body) const { return m_masses[static_cast<std::size_t>(body)]; }

private:
    /// Of a body so far, about its origin.
    struct Sum {
        double mass = 0, x = 0, y = 0, inertia = 0;
    };
    void AddShape(const Snapshot& snapshot, const FixtureState& fixture);

    const scenes::Scene& m_scene;
    nlohmann::ordered_json m_rows;
    std::vector<bool> m_isKnown;
    std::vector<Sum> m_sums;
    std::vector<BodyMass> m_masses;
};

}  // namespace testbed
