// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Are states the same on this machine as on all others? Runs every scene of the catalogue by three kinds of step and
// checks that other numbers of workers, a saved world and a recording lead to the same state; holds a dozen longer runs
// to the golden hashes; checks that a program's rounding mode does not matter. Prints a line per state, which
// tests/platforms/run compares with those of x86-64. Needs nothing but the engine: no test library, no exceptions.
//
//   scree_check          all of that; exit code 1 if anything differs
//   scree_check quick    the scenes alone, a few steps each
//   scree_check save     a world as an image to stdout
//   scree_check load     the hash of the world in the image on stdin, or why it was refused

#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/compiler.h"
#include "base/simd.h"
#include "constraints/contact_block.h"
#include "scree/inspect.h"
#include "scree/scree.h"
#include "testbed/base/hash.h"
#include "testbed/engines/scree_joint.h"
#include "testbed/engines/scree_scene.h"
#include "testbed/engines/scree_shape.h"
#include "testbed/engines/state_hash.h"
#include "tests/determinism/golden_hashes.h"
#include "tests/determinism/small_scenes.h"

#if defined(_WIN32)
#include <fcntl.h>
#include <io.h>
#endif

namespace {

int failures = 0;

void Fail(const std::string& what) {
    ++failures;
    std::printf("DIFFERS %s\n", what.c_str());
}

void Stop(const scree::Error& error, void*) {
    std::printf("REFUSED %s: %s; %s\n", error.function, error.field, error.cure);
    std::exit(2);
}

enum class StepKind { sequential, soft, tolerant };
constexpr StepKind stepKinds[] = {StepKind::sequential, StepKind::soft, StepKind::tolerant};
constexpr const char* kindNames[] = {"sequential", "soft", "tolerant"};

/// A scene in a world, stepped with the spawns that are due.
class Run {
public:
    Run(const scenes::Scene& scene, const scree::WorldDef& def, StepKind kind)
        : m_scene(scene), m_kind(kind), m_conveyor(scene), m_world(std::make_unique<scree::World>(def)) {
        Attach();
        while (m_bodyCount < scene.InitialBodyCount()) AddBody();
        std::vector<scree::Joint*> joints;
        for (const scenes::Joint& joint : scene.joints) {
            joints.push_back(testbed::CreateScreeJoint(*m_world, joint, m_bodies, joints));
        }
    }
    /// Goes on with a saved world as `other` would have.
    Run(const Run& other, std::span<const std::byte> image)
        : m_scene(other.m_scene),
          m_kind(other.m_kind),
          m_conveyor(other.m_scene),
          m_world(scree::LoadWorld(image)),
          m_bodyCount(other.m_bodyCount),
          m_step(other.m_step),
          m_spawned(other.m_spawned) {
        if (m_world != nullptr) Attach();
    }

    void Step(int count = 1) {
        for (; count > 0; --count) {
            StepWorld();
            ++m_step;
            for (; m_spawned < m_scene.spawns.size() && m_scene.spawns[m_spawned].afterStep <= m_step; ++m_spawned) {
                AddBody();
            }
        }
    }
    [[nodiscard]] bool IsLoaded() const { return m_world != nullptr; }
    [[nodiscard]] scree::World& GetWorld() { return *m_world; }
    [[nodiscard]] testbed::Conveyor& GetConveyor() { return m_conveyor; }
    [[nodiscard]] uint64_t GetHash() const { return scree::inspect::GetStateHash(*m_world); }
    /// As the golden hashes are.
    [[nodiscard]] uint64_t GetBodyHash() const {
        std::vector<testbed::BodyState> states;
        for (const scree::Body* body : m_bodies) {
            states.push_back({.index = static_cast<int>(states.size()),
                              .type = {},
                              .position = testbed::FromScree(body->GetPosition()),
                              .sin = 0.0f,
                              .cos = 0.0f,
                              .angle = body->GetAngle(),
                              .linearVelocity = testbed::FromScree(body->GetLinearVelocity()),
                              .angularVelocity = body->GetAngularVelocity(),
                              .awake = body->GetType() != scree::staticBody && body->IsAwake(),
                              .bullet = false});
        }
        return testbed::HashState(states);
    }

private:
    void Attach() {
        m_world->SetErrorHandler(Stop, nullptr);
        m_world->SetContactListener(&m_conveyor);
    }
    void AddBody() { m_bodies.push_back(testbed::CreateScreeBody(*m_world, m_scene, m_bodyCount++)); }
    void StepWorld() {
        switch (m_kind) {
            case StepKind::sequential:
                m_world->Step(m_scene.timeStep, m_scene.velocityIterations, m_scene.positionIterations);
                return;
            case StepKind::soft:
                m_world->Step(m_scene.timeStep, 4);
                return;
            case StepKind::tolerant:
                m_world->Step(m_scene.timeStep, scree::Tolerance{});
                return;
        }
    }

    const scenes::Scene& m_scene;
    const StepKind m_kind;
    testbed::Conveyor m_conveyor;
    std::unique_ptr<scree::World> m_world;
    testbed::ScreeBodies m_bodies;
    int m_bodyCount = 0;
    int m_step = 0;
    size_t m_spawned = 0;
};

scree::WorldDef MakeDef(const scenes::Scene& scene, int workers = 1) {
    scree::WorldDef def;
    def.gravity = testbed::ToScree(scene.gravity);
    def.workerCount = workers;
    return def;
}

uint64_t ChecksumOf(std::span<const std::byte> bytes) {
    testbed::Fnv1a<uint64_t> sum;
    for (const std::byte byte : bytes) sum.Add(static_cast<uint64_t>(byte));
    return sum.Get();
}

void CheckGolden() {
    for (const determinism::GoldenHash& row : determinism::golden) {
        const scenes::Scene scene = scenes::Build(row.scene, row.size);
        for (const StepKind kind : {StepKind::sequential, StepKind::soft}) {
            scree::WorldDef def = MakeDef(scene);
            def.continuousPhysics = false;
            def.maxTranslation = scree::maxTranslation;
            def.maxRotation = scree::maxRotation;
            Run run(scene, def, kind);
            run.Step(row.steps);
            const uint64_t hash = run.GetBodyHash();
            const std::string name = std::string(row.scene) + " " + kindNames[static_cast<int>(kind)];
            std::printf("golden %s %016" PRIx64 "\n", name.c_str(), hash);
            if (hash != (kind == StepKind::soft ? row.softHash : row.hash)) Fail("golden " + name);
        }
    }
}

/// Half of the steps, an image, and the other half; all of it recorded.
void CheckScene(const scenes::Scene& scene, StepKind kind, int halfSteps) {
    const std::string name = scene.name + " " + kindNames[static_cast<int>(kind)];
    scree::Recorder recorder;
    Run run(scene, MakeDef(scene), kind);
    StartRecording(run.GetWorld(), recorder);
    run.Step(halfSteps);
    const std::vector<std::byte> image = SaveWorld(run.GetWorld());
    std::optional<Run> restored;
    restored.emplace(run, image);
    run.Step(halfSteps);
    const uint64_t hash = run.GetHash();
    scree::StopRecording(run.GetWorld());
    std::printf("state %s %016" PRIx64 "\n", name.c_str(), hash);
    std::printf("image %s %016" PRIx64 "\n", name.c_str(), ChecksumOf(image));

    if (restored->IsLoaded()) restored->Step(halfSteps);
    if (!restored->IsLoaded() || restored->GetHash() != hash) Fail(name + ": restored");
    testbed::Conveyor conveyor(scene);
    const scree::ReplayReport replay =
        scree::Replay(recorder.GetBytes(), [&](scree::World& world) { world.SetContactListener(&conveyor); });
    const bool isSame = replay.valid && replay.firstDifference == 0 && replay.steps == 2 * halfSteps;
    if (!isSame || scree::inspect::GetStateHash(*replay.world) != hash) Fail(name + ": replayed");
    for (const int workers : {2, 3, 8}) {
        Run shared(scene, MakeDef(scene, workers), kind);
        shared.Step(2 * halfSteps);
        if (shared.GetHash() != hash) Fail(name + ": " + std::to_string(workers) + " workers");
    }
}

/// Numbers near 0 are rounded to 0, and others downwards, as some programs want it for their threads.
[[maybe_unused]] void SpoilFloatMode(bool spoil) {
#if defined(SCREE_HAS_SSE2)
    _mm_setcsr(spoil ? 0xBFC0 : 0x1F80);
#elif defined(__aarch64__)
    const uint64_t mode = spoil ? 0x01800000 : 0;
    asm volatile("msr fpcr, %0" : : "r"(mode) : "memory");
#elif defined(__arm__)
    const uint32_t mode = spoil ? 0x01800000 : 0;
    asm volatile("vmsr fpscr, %0" : : "r"(mode) : "memory");
#endif
}

/// Pairs of welded boxes and single disks, many enough for several workers, that creep: their moves are denormal.
uint64_t HashOfCreeping(StepKind kind, int workers, bool spoil) {
    scree::WorldDef def;
    def.gravity = {1e-39f, -2e-39f};
    def.workerCount = workers;
    SpoilFloatMode(spoil);  // of threads that are made, too
    scree::World world(def);
    SpoilFloatMode(false);
    scree::PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    scree::CircleShape disk;
    disk.m_radius = 0.5f;
    scree::Body* before = nullptr;
    for (int i = 0; i < 600; ++i) {
        scree::BodyDef body;
        body.type = scree::dynamicBody;
        body.position = {i == 0 ? 0.0f : 1.5f * static_cast<float>(i % 30), 1.5f * static_cast<float>(i / 30)};
        body.linearVelocity = {1e-39f * static_cast<float>(i + 1), 0.3f + 0.01f * static_cast<float>(i % 7)};
        body.angularVelocity = 1e-39f * static_cast<float>(i);
        body.allowSleep = false;
        scree::Body* made = world.CreateBody(&body);
        i % 3 == 0 ? made->CreateFixture(&disk, 1.0f) : made->CreateFixture(&box, 1.0f);
        if (i % 5 == 1) {
            scree::WeldJointDef weld;
            weld.Initialize(before, made, before->GetPosition());
            world.CreateJoint(&weld);
        }
        before = made;
    }
    SpoilFloatMode(spoil);
    for (int i = 0; i < 20; ++i) {
        kind == StepKind::sequential ? world.Step(1.0f / 60.0f, 8, 3) : world.Step(1.0f / 60.0f, 4);
    }
    SpoilFloatMode(false);
    return scree::inspect::GetStateHash(world);
}

void CheckFloatModes() {
    for (const StepKind kind : {StepKind::sequential, StepKind::soft}) {
        const std::string name = kindNames[static_cast<int>(kind)];
        const uint64_t hash = HashOfCreeping(kind, 1, false);
        std::printf("state creeping %s %016" PRIx64 "\n", name.c_str(), hash);
        for (const int workers : {1, 3}) {
            if (HashOfCreeping(kind, workers, true) != hash) {
                Fail("creeping " + name + ", rounding of the program, " + std::to_string(workers) + " workers");
            }
        }
    }
}

int CheckAll(bool quick) {
    const char* order = std::endian::native == std::endian::little ? "little" : "big";
#if defined(SCREE_HAS_THREADS)
    const char* threads = "threads";
#else
    const char* threads = "no threads";
#endif
    std::printf("target %s, kernels %s, %d bits, %s endian, %s\n", scree::simdName, scree::GetContactKernels().name,
                static_cast<int>(8 * sizeof(void*)), order, threads);
    if (!quick) CheckGolden();
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        const scenes::Scene scene = determinism::BuildSmall(info);
        for (const StepKind kind : stepKinds) CheckScene(scene, kind, quick ? 3 : 15);
    }
    if (!quick) CheckFloatModes();
    std::printf("failures %d\n", failures);
    return failures == 0 ? 0 : 1;
}

int Save() {
    const scenes::Scene scene = scenes::Build("ragdolls");
    Run run(scene, MakeDef(scene), StepKind::soft);
    run.Step(60);
    const std::vector<std::byte> image = SaveWorld(run.GetWorld());
    std::fwrite(image.data(), 1, image.size(), stdout);
    return 0;
}

int Load() {
    std::vector<std::byte> image;
    std::byte block[4096];
    for (size_t count = 1; count > 0;) {
        count = std::fread(block, 1, sizeof block, stdin);
        image.insert(image.end(), block, block + count);
    }
    scree::SnapshotError error{};
    const std::unique_ptr<scree::World> world = scree::LoadWorld(image, &error);
    if (world == nullptr) {
        std::printf("refused: %s\n", scree::GetName(error));
        return 0;
    }
    for (int i = 0; i < 30; ++i) world->Step(1.0f / 60.0f, 4);
    std::printf("loaded %016" PRIx64 "\n", scree::inspect::GetStateHash(*world));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
#if defined(_WIN32)
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
#endif
    const std::string what = argc > 1 ? argv[1] : "";
    return what == "save" ? Save() : what == "load" ? Load() : CheckAll(what == "quick");
}
