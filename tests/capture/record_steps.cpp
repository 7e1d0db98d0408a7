// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Takes the place of b2World::Step and ~b2World in programs that it is linked with (the linker's --wrap). Each world is
// recorded from its first step on as N.track in the folder SCREE_TRACKS. Beside it, in N.states, are the bits of all
// bodies, oldest first, one step a line.

#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scree_capture_box2d.h"

namespace {

struct Recorder {
    std::unique_ptr<scree_capture::Track> track;
    std::FILE* states = nullptr;

    void Note(b2World& world) const {
        std::vector<const b2Body*> bodies;
        for (const b2Body* b = world.GetBodyList(); b != nullptr; b = b->GetNext()) bodies.push_back(b);
        for (std::size_t i = bodies.size(); i-- > 0;) {
            scree_capture::detail::State state;
            scree_capture::Api::ReadState(*bodies[i], state);
            for (const std::uint32_t bits : state.bits) std::fprintf(states, "%x ", bits);
            std::fprintf(states, "%d ", state.awake ? 1 : 0);
        }
        std::fprintf(states, "\n");
    }
};

std::map<const b2World*, Recorder>& Recorders() {
    static std::map<const b2World*, Recorder> recorders;
    return recorders;
}

void Finish(const b2World* world) {
    const auto found = Recorders().find(world);
    if (found == Recorders().end()) return;
    found->second.track->Close();
    const std::string error = found->second.track->GetError();
    if (!error.empty()) std::fprintf(stderr, "%s\n", error.c_str());
    std::fclose(found->second.states);
    Recorders().erase(found);
}

Recorder& RecorderOf(b2World& world, int velocityIterations, int positionIterations) {
    static int count = 0;
    Recorder& recorder = Recorders()[&world];
    if (recorder.track == nullptr) {
        const char* folder = std::getenv("SCREE_TRACKS");
        const std::string name = std::string(folder != nullptr ? folder : ".") + "/" + std::to_string(count++);
        scree_capture::Options options;
        options.contacts = options.tree = options.stages = true;
        options.velocityIterations = velocityIterations;
        options.positionIterations = positionIterations;
        recorder.states = std::fopen((name + ".states").c_str(), "w");
        if (recorder.states == nullptr) std::exit(9);
        recorder.Note(world);
        recorder.track = std::make_unique<scree_capture::Track>(world, name + ".track", options);
    }
    return recorder;
}

}  // namespace

extern "C" {

void __real__ZN7b2World4StepEfii(b2World* world, float timeStep, int velocityIterations, int positionIterations);
void __real__ZN7b2WorldD1Ev(b2World* world);
void __wrap__ZN7b2World4StepEfii(b2World* world, float timeStep, int velocityIterations, int positionIterations);
void __wrap__ZN7b2WorldD1Ev(b2World* world);

void __wrap__ZN7b2World4StepEfii(b2World* world, float timeStep, int velocityIterations, int positionIterations) {
    Recorder& recorder = RecorderOf(*world, velocityIterations, positionIterations);
    __real__ZN7b2World4StepEfii(world, timeStep, velocityIterations, positionIterations);
    recorder.track->Step(timeStep);
    recorder.Note(*world);
}

void __wrap__ZN7b2WorldD1Ev(b2World* world) {
    Finish(world);
    __real__ZN7b2WorldD1Ev(world);
}
}
