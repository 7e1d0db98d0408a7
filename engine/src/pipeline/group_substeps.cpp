// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Groups keep the order of the lists that they are parts of. So a world of one group is solved bit for bit as by a step
// with that number of sub-steps.

#include "pipeline/group_substeps.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace scree {

namespace {

/// What is left after a step of what a body called for. A blow is not to make the number swing. The pull in a swung
/// chain goes up and down many times a swing, and its joints would tear if the number followed it.
constexpr float memory = 31.0f / 32.0f;

/// Sub-steps that keep the tolerance at this body if this step is like the last. A resting overlap beyond the slop, and
/// a joint's gap, shrink with the square of their number.
float WantedBy(const BodyDemand& last, const GroupInput& in) {
    const Tolerance& tolerance = in.tolerance;
    if (last.substeps == 0) return static_cast<float>(tolerance.leastSubsteps);
    const float sink = last.overlap / tolerance.overlap;
    const auto taken = static_cast<float>(last.substeps);
    const float exact = taken * std::sqrt(Max(sink, last.jointGap / tolerance.jointGap));
    // The number stays until a smaller one has some room. Errors follow the rule above only roughly, and each change
    // moves what rests: without room the number goes up and down for ever.
    constexpr float room = 4.0f / 3.0f;
    const float byErrors = Max(exact, Min(taken, room * exact));
    const float byPull = 2.0f * in.dt * last.pullRate;
    // One level a step: what a blow calls for at once is over before that many sub-steps are of use.
    const float most = Min(1.5f * taken, static_cast<float>(tolerance.mostSubsteps));
    return std::clamp(Max(Max(byErrors, byPull), memory * last.wanted), static_cast<float>(tolerance.leastSubsteps),
                      Max(most, static_cast<float>(tolerance.leastSubsteps)));
}

/// Notes what a body calls for and starts its demand of this step anew.
float TakeWanted(const GroupInput& in, BodyDemand& demand) {
    const float wanted = WantedBy(demand, in);
    demand = {.wanted = wanted};
    return wanted;
}

/// Springs grow stiffer with the number of sub-steps. What they would then push apart at once, and throw a column by,
/// is left to the pass that leaves no speed (SteadyContact).
void NoteStiffer(ContactIndex contact, int last, int now, ContactTable& contacts) {
    if (last == 0 || now <= last || !contacts.steady.Has(contact)) return;
    float& initial = contacts.steady[contact].initialOverlap;
    const float rate = static_cast<float>(last) / static_cast<float>(now);
    if (initial == 0.0f && contacts.steady[contact].isKept != 0.0f) initial = rate * rate - 1.0f;
}

/// Any group may come to hold nearly all; groups change places and sizes from step to step, and are not to allocate.
void MakeRoom(IslandTable& lists, const IslandTable& all) {
    lists.bodies.reserve(std::bit_ceil(all.bodies.size()));
    lists.contacts.reserve(std::bit_ceil(all.contacts.size()));
    lists.joints.reserve(std::bit_ceil(all.joints.size()));
    lists.isolated.reserve(std::bit_ceil(all.isolated.size()));
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

void SubstepGroups::Enter(int substeps) {
    const auto isBefore = [](const SubstepGroup& group, int number) { return group.substeps < number; };
    const std::span<SubstepGroup> used = Get();
    const auto place = std::lower_bound(used.begin(), used.end(), substeps, isBefore);
    if (place != used.end() && place->substeps == substeps) return;
    const auto at = static_cast<std::ptrdiff_t>(place - used.begin());
    if (m_count == m_groups.size()) m_groups.emplace_back();
    ++m_count;
    const auto begin = m_groups.begin() + at, end = m_groups.begin() + static_cast<std::ptrdiff_t>(m_count);
    std::rotate(begin, end - 1, end);
    begin->substeps = substeps;
    begin->lists.Clear();
}

SubstepGroup& SubstepGroups::Find(int substeps) {
    const std::span<SubstepGroup> used = Get();
    return *std::find_if(used.begin(), used.end(), [&](const SubstepGroup& g) { return g.substeps == substeps; });
}

void GroupBySubsteps(const GroupInput& in, BodyTable& bodies, SubstepGroups& groups) {
    EnsureRows(bodies.demand, bodies.info.size());
    EnsureRows(groups.Last(), bodies.info.size());
    groups.Clear();
    for (const Island& island : in.islands.islands) {
        float wanted = 0.0f;
        for (const BodyIndex body : Bodies(in.islands, island)) {
            groups.Last()[body] = bodies.demand[body].substeps;
            wanted = Max(wanted, TakeWanted(in, bodies.demand[body]));
        }
        const int substeps = RoundUpSubsteps(wanted, in.tolerance);
        for (const BodyIndex body : Bodies(in.islands, island)) bodies.demand[body].substeps = substeps;
        groups.Enter(substeps);
    }
    if (!in.active.isolated.empty()) groups.Enter(in.tolerance.leastSubsteps);
    for (SubstepGroup& group : groups.Get()) MakeRoom(group.lists, in.active);

    for (const BodyIndex body : in.active.isolated) {
        BodyDemand& demand = bodies.demand[body];
        TakeWanted(in, demand);
        demand.substeps = in.tolerance.leastSubsteps;
        groups.Get().front().lists.isolated.push_back(body);
    }
    const auto listsOf = [&](BodyIndex body) -> IslandTable& {
        return groups.Find(bodies.demand[body].substeps).lists;
    };
    const auto moverOf = [&](BodyIndex a, BodyIndex b) { return bodies.type[a] != staticBody ? a : b; };
    for (const BodyIndex body : in.active.bodies) listsOf(body).bodies.push_back(body);
    for (const ContactIndex contact : in.active.contacts) {
        const ContactPair& pair = in.contacts.pair[contact];
        const BodyIndex mover = moverOf(pair.bodyA, pair.bodyB);
        listsOf(mover).contacts.push_back(contact);
        NoteStiffer(contact, groups.Last()[mover], bodies.demand[mover].substeps, in.contacts);
    }
    for (const JointIndex joint : in.active.joints) {
        const JointInfo& info = in.joints.info[joint];
        listsOf(moverOf(info.bodyA, info.bodyB)).joints.push_back(joint);
    }
}

}  // namespace scree
