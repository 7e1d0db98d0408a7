// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// How an engine is to be run: which solver, how many iterations or sub-steps, which time step. One setting is one point
// of the trade between speed and accuracy.

#pragma once

#include <string>

namespace testbed {

/// sequential: sequential impulses with velocity and position iterations (Box2D 2.4's and ours). soft: sub-steps with
/// soft constraints (ours).
enum class SolverKind { sequential, soft };

struct EngineSetting {
    std::string engine = "scree";  ///< "scree" or "box2d"
    SolverKind solver = SolverKind::sequential;
    int velocityIterations = 8;  ///< sequential
    int positionIterations = 3;  ///< sequential
    int substeps = 4;            ///< soft
    int rate = 60;               ///< steps per second

    [[nodiscard]] double GetTimeStep() const { return 1.0 / rate; }

    friend bool operator==(const EngineSetting&, const EngineSetting&) = default;
};

/// The marks on our accuracy dial.
enum class Dial { draft, game, fine, precise };

[[nodiscard]] EngineSetting GetDial(Dial dial, int rate = 60);
[[nodiscard]] EngineSetting GetSequential(const std::string& engine, int velocityIterations = 8,
                                          int positionIterations = 3, int rate = 60);
[[nodiscard]] EngineSetting GetSoft(int substeps, int rate = 60);

/// Whether the engine in this build has that solver.
[[nodiscard]] bool IsAvailable(const EngineSetting& setting);

/// "8/3" or "soft 4".
[[nodiscard]] std::string NameSolver(const EngineSetting& setting);
/// "scree soft 4 at 60 Hz".
[[nodiscard]] std::string NameSetting(const EngineSetting& setting);

}  // namespace testbed
