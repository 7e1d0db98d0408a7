// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of inspector.h. What the engine does not tell, such as of frames that were kept, comes from the
// snapshot alone.

#include "testbed/jobs/window/inspector.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "testbed/base/text.h"
#include "testbed/input/scene_fields.h"

namespace testbed {

namespace {

std::string Print(Vec2 v, const char* unit) { return fmt::format("{:.5g}, {:.5g} {}", v.x, v.y, unit); }

RunValues ValuesOf(const BodyState& body) {
    return {{"type", std::string(bodyTypeNames[static_cast<size_t>(body.type)])},
            {"position", Print(body.position, "m")},
            {"angle", fmt::format("{:.5g} rad", body.angle)},
            {"velocity", Print(body.linearVelocity, "m/s")},
            {"spin", fmt::format("{:.5g} rad/s", body.angularVelocity)},
            {"awake", body.awake ? "yes" : "no"},
            {"bullet", body.bullet ? "yes" : "no"}};
}

RunValues ValuesOf(const FixtureState& fixture) {
    RunValues values;
    const scenes::Shape& shape = fixture.shape;
    if (shape.radius > 0.0f) values.push_back({"radius", fmt::format("{:.5g} m", shape.radius)});
    if (shape.type == scenes::ShapeType::circle) values.push_back({"centre", Print(shape.center, "m")});
    if (shape.type == scenes::ShapeType::box) {
        values.push_back({"half extents", Print(shape.halfExtents, "m")});
        values.push_back({"centre", Print(shape.center, "m")});
        if (shape.angle != 0.0f) values.push_back({"angle", fmt::format("{:.5g} rad", shape.angle)});
    }
    int number = 0;
    for (const Vec2 vertex : shape.Vertices()) {
        values.push_back({fmt::format("vertex {}", number++), Print(vertex, "m")});
    }
    values.push_back({"box from", Print(fixture.tight.lower, "m")});
    values.push_back({"box to", Print(fixture.tight.upper, "m")});
    return values;
}

RunValues ValuesOf(const ContactState& contact, int fixture, int other) {
    RunValues values{{"touching", contact.touching ? "yes" : "no"},
                     {"fixtures", fmt::format("{} and {}", fixture, other)},
                     {"normal, A to B", Print(contact.normal, "")}};
    for (int k = 0; k < contact.pointCount; ++k) {
        values.push_back({fmt::format("point {}", k), Print(contact.points[k], "m")});
        values.push_back({"  separation", fmt::format("{:.5g} m", contact.separations[k])});
        values.push_back({"  impulse", fmt::format("{:.5g} N s", contact.normalImpulses[k])});
        values.push_back({"  friction", fmt::format("{:.5g} N s", contact.tangentImpulses[k])});
    }
    if (contact.color >= 0) values.push_back({"colour", std::to_string(contact.color)});
    return values;
}

void Append(RunValues& values, RunValues more) {
    values.insert(values.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void AddShapes(const EnginePane& pane, int place, Inspection& inspection) {
    const Snapshot& s = pane.snapshot;
    for (size_t i = 0; i < s.fixtures.size(); ++i) {
        if (s.fixtures[i].body != place) continue;
        InspectedPart part{fmt::format("{} {}", shapeTypeNames[static_cast<size_t>(s.fixtures[i].shape.type)], i)};
        part.values = pane.run->ValuesOfFixture(static_cast<int>(i));
        Append(part.values, ValuesOf(s.fixtures[i]));
        inspection.shapes.push_back(std::move(part));
    }
}

void AddContacts(const Viewer& viewer, const EnginePane& pane, int place, Inspection& inspection) {
    const Snapshot& s = pane.snapshot;
    for (const ContactState& contact : s.contacts) {
        const auto placeOf = [&](int fixture) { return s.fixtures[static_cast<size_t>(fixture)].body; };
        const bool isA = placeOf(contact.fixtureA) == place, isB = placeOf(contact.fixtureB) == place;
        if (!isA && !isB) continue;
        const int other = s.bodies[static_cast<size_t>(placeOf(isA ? contact.fixtureB : contact.fixtureA))].index;
        inspection.contacts.push_back({fmt::format("with {}, {} points", NameOfBody(viewer, other), contact.pointCount),
                                       other, ValuesOf(contact, contact.fixtureA, contact.fixtureB)});
    }
}

void AddJoints(const Viewer& viewer, const EnginePane& pane, int place, Inspection& inspection) {
    const Snapshot& s = pane.snapshot;
    for (size_t i = 0; i < s.joints.size(); ++i) {
        const JointState& joint = s.joints[i];
        if (joint.bodyA != place && joint.bodyB != place) continue;
        const int other = s.bodies[static_cast<size_t>(joint.bodyA == place ? joint.bodyB : joint.bodyA)].index;
        const std::string_view type = jointTypeNames[static_cast<size_t>(joint.type)];
        InspectedPart part{fmt::format("{} {}, {}", type, i, NameOfBody(viewer, other)), other};
        part.values = {{"anchor A", Print(joint.anchorA, "m")}, {"anchor B", Print(joint.anchorB, "m")}};
        Append(part.values, pane.run->ValuesOfJoint(static_cast<int>(i)));
        inspection.joints.push_back(std::move(part));
    }
}

constexpr std::array<std::string_view, 6> edited{"position", "angle", "velocity", "spin", "damping", "angular damping"};
constexpr std::array<std::string_view, 7> editedToo{"gravity scale", "density",        "type",     "awake",
                                                    "bullet",        "fixed rotation", "may sleep"};

float ParseOne(std::string_view name, std::string_view text) {
    const size_t first = text.find_first_not_of(' ');
    if (first != std::string_view::npos) text.remove_prefix(first);
    const size_t end = text.find(' ');  // a unit may follow
    const Parsed<float> value = ParseNumber<float>(text.substr(0, end));
    if (!value) throw std::invalid_argument(fmt::format("{}: '{}': {}", name, text, value.problem));
    return *value;
}

Vec2 ParseTwo(std::string_view name, std::string_view text) {
    const size_t comma = text.find(',');
    if (comma == std::string_view::npos) throw std::invalid_argument(fmt::format("{}: give x, y", name));
    return {ParseOne(name, text.substr(0, comma)), ParseOne(name, text.substr(comma + 1))};
}

}  // namespace

Inspection Inspect(const Viewer& viewer, const EnginePane& pane) {
    Inspection inspection;
    const int place = FindBody(pane.snapshot, viewer.pickedBody);
    if (place < 0) return inspection;
    inspection.title = NameOfBody(viewer, viewer.pickedBody);
    inspection.values = pane.run->ValuesOfBody(viewer.pickedBody);
    if (inspection.values.empty()) inspection.values = ValuesOf(pane.snapshot.bodies[static_cast<size_t>(place)]);
    AddShapes(pane, place, inspection);
    AddContacts(viewer, pane, place, inspection);
    AddJoints(viewer, pane, place, inspection);
    if (!inspection.shapes.empty() && !inspection.shapes.front().values.empty()) {
        const RunValue& density = inspection.shapes.front().values.front();
        if (density.name == "density") inspection.values.push_back(density);
    }
    return inspection;
}

bool IsEditable(std::string_view name) {
    return std::ranges::find(edited, name) != edited.end() || std::ranges::find(editedToo, name) != editedToo.end();
}

BodyEdit ParseEdit(std::string_view name, std::string_view text) {
    BodyEdit edit;
    if (name == "position") {
        edit.position = ParseTwo(name, text);
    } else if (name == "velocity") {
        edit.linearVelocity = ParseTwo(name, text);
    } else if (name == "type") {
        const auto found = std::ranges::find(bodyTypeNames, text);
        if (found == bodyTypeNames.end()) throw std::invalid_argument("type: give static, kinematic or dynamic");
        edit.type = static_cast<scenes::BodyType>(found - bodyTypeNames.begin());
    } else {
        for (const auto& [known, member] : {std::pair{"angle", &BodyEdit::angle},
                                            {"spin", &BodyEdit::angularVelocity},
                                            {"density", &BodyEdit::density},
                                            {"damping", &BodyEdit::linearDamping},
                                            {"angular damping", &BodyEdit::angularDamping},
                                            {"gravity scale", &BodyEdit::gravityScale}}) {
            if (name == known) edit.*member = ParseOne(name, text);
        }
        for (const auto& [known, member] : {std::pair{"awake", &BodyEdit::awake},
                                            {"bullet", &BodyEdit::bullet},
                                            {"fixed rotation", &BodyEdit::fixedRotation},
                                            {"may sleep", &BodyEdit::allowSleep}}) {
            if (name == known) edit.*member = text == "yes";
        }
    }
    if (edit == BodyEdit{}) throw std::invalid_argument(fmt::format("{} cannot be changed", name));
    return edit;
}

}  // namespace testbed
