// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// One look at the masses of each contact.

#include "constraints/load_bearers.h"

#include "base/gather_parts.h"

namespace scree {

void LoadBearers::Find(TaskPool& pool, const BodyTable& bodies, const ContactTable& contacts,
                       std::span<const ContactIndex> list) {
    Forget();                       // a step that ran out of memory has left some
    constexpr float heavy = 10.0f;  // masses of the body that bears it
    constexpr int leastToShare = 1024;
    const auto bears = [&](BodyIndex body, BodyIndex load) {
        const float invMass = bodies.mass[load].invMass;
        return bodies.info[body].jointCount > 0 && invMass > 0.0f && heavy * invMass < bodies.mass[body].invMass;
    };
    GatherParts<BodyIndex, 1>(pool, static_cast<int>(list.size()), leastToShare, {&m_bearers},
                              [&](int begin, int end, const std::array<BodyIndex*, 1>& places) {
                                  BodyIndex* place = places[0];
                                  for (const ContactIndex contact : list.subspan(ToSize(begin), ToSize(end - begin))) {
                                      const ContactPair& pair = contacts.pair[contact];
                                      if (bears(pair.bodyA, pair.bodyB)) *place++ = pair.bodyA;
                                      if (bears(pair.bodyB, pair.bodyA)) *place++ = pair.bodyB;
                                  }
                                  return std::array{static_cast<size_t>(place - places[0])};
                              });
    if (m_bearers.empty()) return;
    EnsureRows(m_bears, bodies.mass.size(), uint8_t{0});
    for (const BodyIndex body : m_bearers) m_bears[body] = 1;
}

void LoadBearers::Forget() {
    for (const BodyIndex body : m_bearers) m_bears[body] = 0;
    m_bearers.clear();
}

}  // namespace scree
