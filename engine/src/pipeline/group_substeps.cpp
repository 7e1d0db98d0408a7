// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Groups keep the order of the lists that they are parts of: a world of one group is solved bit for bit as by a step
// with that number of sub-steps.

#include "pipeline/group_substeps.h"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

size_t Row(int index) { return static_cast<size_t>(index); }

/// What is left after a step of what a body called for: a blow is not to make the number swing, and joints of swung
/// chains, whose pull goes up and down many times a swing, would tear if it followed them.
constexpr float memory = 31.0f / 32.0f;

/// Sub-steps that keep the tolerance at this body if this step is like the last: a resting overlap beyond the slop and
/// a joint's gap shrink with the square of their number.
float WantedBy(const BodyDemand& last, const GroupInput& in) {
    const Tolerance& tolerance = in.tolerance;
    if (last.substeps == 0) return static_cast<float>(tolerance.leastSubsteps);
    const float sink = Max(last.overlap - in.slop, 0.0f) / (tolerance.overlap - in.slop);
    const float byErrors = static_cast<float>(last.substeps) * std::sqrt(Max(sink, last.jointGap / tolerance.jointGap));
    const float byPull = 2.0f * in.dt * last.pullRate;
    return std::clamp(Max(Max(byErrors, byPull), memory * last.wanted), static_cast<float>(tolerance.leastSubsteps),
                      static_cast<float>(tolerance.mostSubsteps));
}

/// Notes what a body calls for and starts its demand of this step anew.
float TakeWanted(const GroupInput& in, BodyDemand& demand) {
    const float wanted = WantedBy(demand, in);
    demand = {.wanted = wanted};
    return wanted;
}

SubstepGroup& GroupOf(std::vector<SubstepGroup>& groups, int substeps) {
    return *std::find_if(groups.begin(), groups.end(), [&](const SubstepGroup& g) { return g.substeps == substeps; });
}

}  // namespace

int RoundUpSubsteps(float wanted, const Tolerance& tolerance) {
    int64_t level = 1;
    while (static_cast<float>(2 * level) <= wanted) level *= 2;
    if (static_cast<float>(level) < wanted)
        level = 2.0f * wanted <= static_cast<float>(3 * level) ? 3 * level / 2 : 2 * level;
    if (level == 1 && wanted > 1.0f) level = 2;
    return static_cast<int>(std::clamp<int64_t>(level, tolerance.leastSubsteps, tolerance.mostSubsteps));
}

void GroupBySubsteps(const GroupInput& in, BodyTable& bodies, std::vector<SubstepGroup>& groups) {
    bodies.demand.resize(bodies.info.size());
    groups.clear();
    const auto enter = [&](int substeps) {
        const bool isNew =
            std::none_of(groups.begin(), groups.end(), [&](const auto& g) { return g.substeps == substeps; });
        if (isNew) groups.push_back({substeps, {}});
    };
    for (const Island& island : in.islands.islands) {
        float wanted = 0.0f;
        for (const int body : Bodies(in.islands, island)) {
            wanted = Max(wanted, TakeWanted(in, bodies.demand[Row(body)]));
        }
        const int substeps = RoundUpSubsteps(wanted, in.tolerance);
        for (const int body : Bodies(in.islands, island)) bodies.demand[Row(body)].substeps = substeps;
        enter(substeps);
    }
    if (!in.active.isolated.empty()) enter(in.tolerance.leastSubsteps);
    std::sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.substeps < b.substeps; });

    for (const int body : in.active.isolated) {
        BodyDemand& demand = bodies.demand[Row(body)];
        TakeWanted(in, demand);
        demand.substeps = in.tolerance.leastSubsteps;
    }
    if (!in.active.isolated.empty()) groups.front().lists.isolated = in.active.isolated;
    const auto listsOf = [&](int body) -> IslandTable& {
        return GroupOf(groups, bodies.demand[Row(body)].substeps).lists;
    };
    const auto moverOf = [&](int a, int b) { return bodies.type[Row(a)] != staticBody ? a : b; };
    for (const int body : in.active.bodies) listsOf(body).bodies.push_back(body);
    for (const int contact : in.active.contacts) {
        const ContactPair& pair = in.contacts.pair[Row(contact)];
        listsOf(moverOf(pair.bodyA, pair.bodyB)).contacts.push_back(contact);
    }
    for (const int joint : in.active.joints) {
        const JointInfo& info = in.joints.info[Row(joint)];
        listsOf(moverOf(info.bodyA, info.bodyB)).joints.push_back(joint);
    }
}

}  // namespace scree
