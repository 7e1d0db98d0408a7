// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A game that learns of another player's input six frames late: it goes back, and plays these frames again with it.

#include <cstdio>

#include "scree/inspect.h"
#include "scree/scree.h"

namespace {

constexpr int lateBy = 6, frameOfInput = 40, frameCount = 90;

class Game {
public:
    Game() {
        scree::BodyDef def;
        scree::PolygonShape box;
        box.SetAsBox(20.0f, 0.5f);
        m_world.CreateBody(&def)->CreateFixture(&box, 0.0f);
        def.type = scree::dynamicBody;
        box.SetAsBox(0.5f, 0.5f);
        for (int i = 0; i < 10; ++i) {
            def.position = {0.0f, 1.0f + 1.1f * static_cast<float>(i)};
            m_body = m_world.CreateBody(&def);
            m_body->CreateFixture(&box, 1.0f);
        }
    }
    void Play(int frame, bool knowsInput) {
        if (knowsInput && frame == frameOfInput) m_body->ApplyLinearImpulseToCenter({3.0f, 0.0f}, true);
        m_world.Step(1.0f / 60.0f, scree::Accuracy::game);
    }
    scree::World& GetWorld() { return m_world; }

private:
    scree::World m_world{{0.0f, -10.0f}};
    scree::Body* m_body = nullptr;
};

}  // namespace

int main() {
    Game late, informed;
    scree::Rollback moments(late.GetWorld(), lateBy + 1);
    for (int frame = 0; frame < frameCount; ++frame) {
        moments.Save();  // moment n: before frame n
        late.Play(frame, false);
        informed.Play(frame, true);
        if (frame != frameOfInput + lateBy) continue;
        moments.Restore(frameOfInput);
        for (int again = frameOfInput; again <= frame; ++again) late.Play(again, true);
    }
    const bool isEqual =
        scree::inspect::GetStateHash(late.GetWorld()) == scree::inspect::GetStateHash(informed.GetWorld());
    std::printf("the two players' worlds are %s\n", isEqual ? "equal, bit for bit" : "different");
}

// Output:
// the two players' worlds are equal, bit for bit
