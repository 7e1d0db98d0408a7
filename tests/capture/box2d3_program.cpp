// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// A program with a world of Box2D 3 that records it: shapes of all kinds, joints, bodies that come, go and sleep.
// Argument: the folder of session.track, start.scene.json, states.txt (each body after each step) and contacts.txt
// (after the last).

#include "scree_capture_box2d3.h"

#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef std::vector<std::pair<std::string, b2BodyId> > Bodies;

b2BodyId AddBody(b2WorldId world, b2BodyType type, float x, float y) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = type;
    def.position.x = x;
    def.position.y = y;
    return b2CreateBody(world, &def);
}

void AddLevel(b2WorldId world, Bodies& bodies) {
    const b2ShapeDef shape = b2DefaultShapeDef();
    bodies.push_back(std::make_pair("floor", AddBody(world, b2_staticBody, 0.0f, 0.0f)));
    const b2Segment segment = {{-20.0f, 0.0f}, {20.0f, 0.0f}};
    b2CreateSegmentShape(bodies.back().second, &shape, &segment);
    bodies.push_back(std::make_pair("hill", AddBody(world, b2_staticBody, 12.0f, 0.0f)));
    const b2Vec2 points[] = {{6.0f, 3.0f}, {3.0f, 2.0f}, {1.0f, 1.0f}, {-2.0f, 0.0f}};
    b2ChainDef chain = b2DefaultChainDef();
    chain.points = points;
    chain.count = 4;
    b2CreateChain(bodies.back().second, &chain);
}

void AddMovers(b2WorldId world, Bodies& bodies) {
    b2ShapeDef shape = b2DefaultShapeDef();
    shape.filter.categoryBits = 2;
    const b2Polygon box = b2MakeBox(0.5f, 0.5f), rounded = b2MakeRoundedBox(0.4f, 0.4f, 0.1f);
    const b2Circle circle = {{0.1f, 0.0f}, 0.4f};
    const b2Capsule capsule = {{-0.3f, 0.0f}, {0.3f, 0.0f}, 0.25f};
    for (int i = 0; i < 12; ++i) {
        const b2BodyId body =
            AddBody(world, b2_dynamicBody, -8.0f + static_cast<float>(i % 6), 1.0f + static_cast<float>(i));
        if (i % 4 == 0) b2CreatePolygonShape(body, &shape, &box);
        if (i % 4 == 1) b2CreateCircleShape(body, &shape, &circle);
        if (i % 4 == 2) b2CreateCapsuleShape(body, &shape, &capsule);
        if (i % 4 == 3) b2CreatePolygonShape(body, &shape, &rounded);
        b2Body_SetAngularVelocity(body, 0.5f * static_cast<float>(i));
        bodies.push_back(std::make_pair("mover " + std::to_string(i), body));
    }
    const b2BodyId wheel = AddBody(world, b2_kinematicBody, 6.0f, 4.0f);
    b2CreatePolygonShape(wheel, &shape, &box);
    b2Body_SetAngularVelocity(wheel, 9.0f);  // more than half a turn between two seconds
    bodies.push_back(std::make_pair("wheel", wheel));
}

template <typename Def>
void Join(Def& def, b2BodyId a, b2BodyId b, float anchorA) {
    def.base.bodyIdA = a;
    def.base.bodyIdB = b;
    def.base.localFrameA.p.x = anchorA;
}

void AddJoints(b2WorldId world, const Bodies& bodies) {
    b2RevoluteJointDef revolute = b2DefaultRevoluteJointDef();
    Join(revolute, bodies[2].second, bodies[3].second, 1.0f);
    revolute.enableLimit = true;
    revolute.lowerAngle = -1.0f;
    revolute.upperAngle = 1.0f;
    b2CreateRevoluteJoint(world, &revolute);
    b2DistanceJointDef distance = b2DefaultDistanceJointDef();
    Join(distance, bodies[4].second, bodies[5].second, 0.0f);
    distance.enableSpring = true;
    distance.hertz = 2.0f;
    distance.dampingRatio = 0.3f;
    distance.length = 1.5f;
    b2CreateDistanceJoint(world, &distance);
    b2WeldJointDef weld = b2DefaultWeldJointDef();
    Join(weld, bodies[6].second, bodies[7].second, 1.0f);
    b2CreateWeldJoint(world, &weld);
    b2FilterJointDef filter = b2DefaultFilterJointDef();  // no scene has these
    Join(filter, bodies[8].second, bodies[9].second, 0.0f);
    b2CreateFilterJoint(world, &filter);
}

void WriteStates(std::FILE* file, int step, const Bodies& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const b2BodyId id = bodies[i].second;
        if (!b2Body_IsValid(id)) continue;
        const scree_capture::Point p = scree_capture::ToPoint(b2Body_GetPosition(id));
        const b2Vec2 v = b2Body_GetLinearVelocity(id);
        const b2Rot q = b2Body_GetRotation(id);
        std::fprintf(file, "%d %a %a %a %a %a %a %a %d %s\n", step, static_cast<double>(p.x), static_cast<double>(p.y),
                     static_cast<double>(q.c), static_cast<double>(q.s), static_cast<double>(v.x),
                     static_cast<double>(v.y), static_cast<double>(b2Body_GetAngularVelocity(id)),
                     b2Body_IsAwake(id) ? 1 : 0, bodies[i].first.c_str());
    }
}

std::string NameOf(b2ShapeId shape, const Bodies& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (B2_ID_EQUALS(bodies[i].second, b2Shape_GetBody(shape))) return bodies[i].first;
    }
    return "nobody";
}

std::string Describe(const b2ContactData& contact, const Bodies& bodies) {
    std::string line = NameOf(contact.shapeIdA, bodies) + "|" + NameOf(contact.shapeIdB, bodies);
    for (int i = 0; i < contact.manifold.pointCount; ++i) {
        const b2ManifoldPoint& point = contact.manifold.points[i];
        char text[80];
        std::snprintf(text, sizeof text, " %a %a", static_cast<double>(point.separation),
                      static_cast<double>(point.normalImpulse));
        line += text;
    }
    return line;
}

/// Contacts as the shapes tell them, each once: names, and of each point separation and impulse.
void WriteContacts(const std::string& path, const Bodies& bodies) {
    std::set<std::string> lines;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (!b2Body_IsValid(bodies[i].second)) continue;
        b2ShapeId shapes[8];
        const int count = b2Body_GetShapes(bodies[i].second, shapes, 8);
        for (int k = 0; k < count; ++k) {
            b2ContactData data[32];
            const int contacts = b2Shape_GetContactData(shapes[k], data, 32);
            for (int c = 0; c < contacts; ++c) lines.insert(Describe(data[c], bodies));
        }
    }
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) return;
    for (std::set<std::string>::const_iterator i = lines.begin(); i != lines.end(); ++i) {
        std::fprintf(file, "%s\n", i->c_str());
    }
    std::fclose(file);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    b2WorldDef worldDef = b2DefaultWorldDef();
    const b2WorldId world = b2CreateWorld(&worldDef);
    Bodies bodies;
    AddLevel(world, bodies);
    AddMovers(world, bodies);
    AddJoints(world, bodies);

    scree_capture::Options options;
    options.contacts = options.stages = true;
    bool isGood = scree_capture::WriteScene(world, folder + "/start.scene.json");
    scree_capture::Track track(world, folder + "/session.track", options);
    for (std::size_t i = 0; i < bodies.size(); ++i) track.Name(bodies[i].second, bodies[i].first);
    std::FILE* states = std::fopen((folder + "/states.txt").c_str(), "w");
    if (states == nullptr) return 2;
    for (int step = 1; step <= 240; ++step) {
        if (step == 60) b2DestroyBody(bodies[13].second);
        if (step == 80) {
            // Its slot is the one of the body that went.
            bodies.push_back(std::make_pair("late", AddBody(world, b2_dynamicBody, 0.0f, 9.0f)));
            const b2ShapeDef shape = b2DefaultShapeDef();
            const b2Circle circle = {{0.0f, 0.0f}, 0.3f};
            b2CreateCircleShape(bodies.back().second, &shape, &circle);
            track.Name(bodies.back().second, "late");
        }
        b2World_Step(world, 1.0f / 60.0f, 4);
        track.Step(1.0f / 60.0f);
        WriteStates(states, step, bodies);
    }
    track.Close();
    std::fclose(states);
    WriteContacts(folder + "/contacts.txt", bodies);
    isGood = isGood && track.GetError().empty() && track.GetSkippedSteps() == 0;
    b2DestroyWorld(world);
    return isGood ? 0 : 1;
}
