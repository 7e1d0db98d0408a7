// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How far states of a scene are from exact ones, measured alike for all engines. Bodies are put into a world of ours
// where an engine left them, and World::MeasureErrors tells overlap and joint gaps. Energy and distances are summed in
// double.

#pragma once

#include <memory>
#include <span>

#include "testbed/engines/snapshot.h"

namespace testbed {

/// As StepErrors of the engine; infinite for a state that is not finite.
struct StateErrors {
    double overlap = 0.0;   ///< deepest of touching shapes, m
    double jointGap = 0.0;  ///< largest, m
};

class StateJudge {
public:
    /// Throws std::invalid_argument for a scene that our engine refuses.
    explicit StateJudge(const scenes::Scene& scene);
    ~StateJudge();
    StateJudge(const StateJudge&) = delete;
    StateJudge& operator=(const StateJudge&) = delete;

    /// Bodies of the scene that are not among `bodies` take no part. `outlines`: shapes rest where their outlines touch
    /// (soft steps), not where their skins overlap by the slop. O(bodies + contacts).
    [[nodiscard]] StateErrors Measure(std::span<const BodyState> bodies, bool outlines);

    /// Kinetic and potential energy of the dynamic ones among `bodies` over their mass, J/kg.
    [[nodiscard]] double GetEnergy(std::span<const BodyState> bodies, Vec2 gravity) const;

    /// Root mean square, over the dynamic bodies that are in both, of how far the mass of each is from where the other
    /// state has it, m. Both list bodies by growing index. 0 without such bodies.
    [[nodiscard]] double GetDistance(std::span<const BodyState> one, std::span<const BodyState> other) const;

    /// Root mean square of the longer sides of the boxes around dynamic bodies at the start, m; 1 without any.
    [[nodiscard]] double GetBodySize() const;
    [[nodiscard]] bool HasJoints() const;

private:
    struct World;
    std::unique_ptr<World> m_world;
};

}  // namespace testbed
