// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The window's picture without a window: panels and scenes through our own renderer of draw lists. Equal state gives
// equal pixels, another value gives other pixels, and only where it is shown.

#include "testbed/jobs/window/frame.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "testbed/gl/context.h"
#include "testbed/jobs/window/panels.h"

namespace testbed {
namespace {

constexpr int width = 900, height = 640;

/// A viewer with everything that draws it, paused at step 3 of a small pyramid.
class Screen {
public:
    Screen() : m_context(MakeContext(Backend::automatic)), m_renderer(Find, m_context.get()) {
        int fontWidth = 0, fontHeight = 0;
        const unsigned char* font = m_gui.GetFontPixels(fontWidth, fontHeight);
        m_renderer.SetFont(font, fontWidth, fontHeight);
        viewer.showTimes = false;
        viewer.isPaused = true;
        viewer.look.layers.Set(Layer::bodies);
        const scenes::SceneInfo& info = *scenes::Find("pyramid");
        LoadScene(viewer, MakeInput(info, 4));
        for (int i = 0; i < 3; ++i) StepAll(viewer);
        viewer.message.clear();
    }

    Image Draw(std::vector<InputEvent> events = {}) {
        m_context->MakeCurrent();
        DrawFrame(viewer, m_gui, items, m_renderer, {events, width, height, 1.0 / 60});
        return m_renderer.Read();
    }

    Viewer viewer;
    Items items;

private:
    static Context::Function Find(void* user, const char* name) {
        return static_cast<const Context*>(user)->GetFunction(name);
    }
    std::unique_ptr<Context> m_context;
    WindowRenderer m_renderer;
    Gui m_gui;
};

/// Where two pictures differ; empty when they are equal.
PixelBox FindDifference(const Image& a, const Image& b) {
    PixelBox box{width, height, 0, 0};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (a.At(x, y) == b.At(x, y)) continue;
            box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), std::max(box.y1, y + 1)};
        }
    }
    return box;
}

bool IsEmpty(const PixelBox& box) { return box.x0 >= box.x1; }

Image DrawSettled(Screen& screen) {
    for (int i = 0; i < 3; ++i) (void)screen.Draw();  // panels find their sizes in the first frames
    return screen.Draw();
}

TEST(Frame, EqualStatesGiveEqualPixels) {
    Image first;
    {
        Screen screen;
        first = DrawSettled(screen);
        EXPECT_TRUE(IsEmpty(FindDifference(first, screen.Draw()))) << "nothing changes by itself";
    }
    Screen again;
    EXPECT_TRUE(IsEmpty(FindDifference(first, DrawSettled(again))));
}

TEST(Frame, AValueChangesTheWidgetThatShowsIt) {
    Screen screen;
    const Image before = DrawSettled(screen);
    SetIterations(screen.viewer, {30, screen.viewer.iterations.position});
    const PixelBox changed = FindDifference(before, screen.Draw());
    ASSERT_FALSE(IsEmpty(changed));
    const ItemBox item = screen.items.at("solver.velocity");
    EXPECT_GE(changed.x0, static_cast<int>(item.x0));
    EXPECT_GE(changed.y0, static_cast<int>(item.y0));
    EXPECT_LE(changed.x1, static_cast<int>(item.x1) + 1);
    EXPECT_LE(changed.y1, static_cast<int>(item.y1) + 1);
}

TEST(Frame, EveryLayerOfTheListHasASwitch) {
    Screen screen;
    (void)DrawSettled(screen);
    for (const LayerInfo& layer : layerTable) {
        const bool wasOn = screen.viewer.look.layers.Has(layer.layer);
        ASSERT_TRUE(screen.items.contains("layer." + std::string(layer.name))) << layer.name;
        const ItemBox item = screen.items.at("layer." + std::string(layer.name));
        const InputEvent move{InputEvent::Kind::move, item.x0 + 8, (item.y0 + item.y1) / 2, 0, false};
        (void)screen.Draw({move, {InputEvent::Kind::button, 0, 0, 0, true}});
        (void)screen.Draw({{InputEvent::Kind::button, 0, 0, 0, false}});
        EXPECT_NE(screen.viewer.look.layers.Has(layer.layer), wasOn) << layer.name;
    }
}

TEST(Frame, ALayerIsDrawnInThePanes) {
    Screen screen;
    const Image with = DrawSettled(screen);
    screen.viewer.look.layers.Set(Layer::bodies, false);
    const PixelBox pane = screen.viewer.panes[0].area;
    const Image without = screen.Draw();
    int changed = 0;
    for (int y = pane.y0; y < pane.y1; ++y) {
        for (int x = pane.x0; x < pane.x1; ++x) changed += with.At(x, y) != without.At(x, y);
    }
    // Ten boxes of 1 m and a ground, at the scale of the pane.
    const double pixelsOfABox = screen.viewer.pixelsPerMetre * screen.viewer.pixelsPerMetre;
    EXPECT_GT(changed, 10 * pixelsOfABox * 0.8);
}

TEST(Frame, PanelsDoNotOverlapTheScenesNorThePanesEachOther) {
    Screen screen;
    (void)DrawSettled(screen);
    const PixelBox area = GetSceneArea(screen.viewer, width, height);
    ASSERT_EQ(screen.viewer.panes.size(), 2u);
    const PixelBox a = screen.viewer.panes[0].area, b = screen.viewer.panes[1].area;
    for (const PixelBox& pane : {a, b}) {
        EXPECT_GE(pane.x0, area.x0);
        EXPECT_GE(pane.y0, area.y0);
        EXPECT_LE(pane.x1, area.x1);
        EXPECT_LE(pane.y1, area.y1);
    }
    EXPECT_TRUE(a.x1 <= b.x0 || a.y1 <= b.y0);
    for (const auto& [name, item] : screen.items) {
        const bool isOutside = item.x1 <= static_cast<float>(area.x0) || item.x0 >= static_cast<float>(area.x1) ||
                               item.y1 <= static_cast<float>(area.y0) || item.y0 >= static_cast<float>(area.y1);
        EXPECT_TRUE(isOutside) << name << " covers a scene";
    }
}

TEST(Frame, NoClickIsLostWhenPressAndReleaseComeInOneFrame) {
    Screen screen;
    (void)DrawSettled(screen);
    const ItemBox item = screen.items.at("step");
    const int before = screen.viewer.panes[0].snapshot.step;
    const InputEvent move{InputEvent::Kind::move, item.x0 + 5, item.y0 + 5, 0, false};
    (void)screen.Draw({move, {InputEvent::Kind::button, 0, 0, 0, true}, {InputEvent::Kind::button, 0, 0, 0, false}});
    (void)screen.Draw();
    (void)screen.Draw();
    EXPECT_EQ(screen.viewer.panes[0].snapshot.step, before + 1);
}

TEST(Frame, TheCameraKeepsThePointUnderThePointerWhenItZooms) {
    Screen screen;
    (void)DrawSettled(screen);
    const EnginePane& pane = screen.viewer.panes[1];
    const Camera before = GetCamera(screen.viewer, pane);
    const Vec2 point = ToWorldPoint(before, 90, 70);
    ZoomAt(screen.viewer, pane, 90, 70, 1.7);
    const Camera after = GetCamera(screen.viewer, pane);
    EXPECT_NEAR(after.pixelsPerMetre, before.pixelsPerMetre * 1.7, 1e-9);
    EXPECT_NEAR(after.ToPixelX(point.x), 90, 1e-4);  // the point is a pair of floats of some metres
    EXPECT_NEAR(after.ToPixelY(point.y), 70, 1e-4);
}

}  // namespace
}  // namespace testbed
