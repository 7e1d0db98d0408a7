// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// `scree view`: the window. With --offscreen the same pictures come from a context without a display, for scripts and
// tests.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "testbed/base/errors.h"
#include "testbed/base/input.h"
#include "testbed/base/output.h"
#include "testbed/base/stopwatch.h"
#include "testbed/engines/saved_world.h"
#include "testbed/jobs/window/commands.h"
#include "testbed/jobs/window/frame.h"
#include "testbed/jobs/window/script.h"
#include "testbed/jobs/window/window.h"
#include "testbed/options/condition_options.h"
#include "testbed/options/options.h"
#include "testbed/picture/png.h"

namespace testbed {

namespace {

struct ViewArguments {
    std::string scene = "tumbler";
    std::optional<int> size;
    InputArguments input;
    SettingArguments settings;
    std::string layers = "bodies,joints";
    std::string nodes = "internal";
    std::string style = "alpha";
    std::string camera = "fit";
    std::string theme = "dark";
    std::string window = "1280x800";
    bool isPaused = false;
    bool noOverlap = false;
    bool noTimes = false;
    int stepsBefore = 0;
    std::optional<int> frames;
    std::string script, screenshot, dumpState;
    int memory = 256;
    ConditionArguments conditions;
    bool isOffscreen = false;
    std::string backend = "auto";
};

/// Where frames go: a window, or nowhere but into the renderer's picture.
class Stage {
public:
    Stage(const ViewArguments& arguments, int width, int height, const ContextOptions& contextOptions)
        : m_width(width), m_height(height) {
        if (arguments.isOffscreen) {
            m_context = MakeContext(ParseBackend(arguments.backend), contextOptions);
        } else {
            m_window = std::make_unique<Window>(width, height, "scree");
            m_window->SetVerticalSync(!arguments.frames.has_value());
        }
    }

    [[nodiscard]] std::unique_ptr<WindowRenderer> MakeRenderer() const {
        if (m_context) {
            return std::make_unique<WindowRenderer>(
                [](void* user, const char* name) { return static_cast<const Context*>(user)->GetFunction(name); },
                m_context.get());
        }
        return std::make_unique<WindowRenderer>(
            [](void* user, const char* name) { return static_cast<const Window*>(user)->GetFunction(name); },
            m_window.get());
    }
    [[nodiscard]] std::vector<InputEvent> Poll() { return m_window ? m_window->Poll() : std::vector<InputEvent>{}; }
    [[nodiscard]] bool WantsToClose() const { return m_window && m_window->WantsToClose(); }
    [[nodiscard]] int GetWidth() const { return m_window ? m_window->GetWidth() : m_width; }
    [[nodiscard]] int GetHeight() const { return m_window ? m_window->GetHeight() : m_height; }
    void Show(WindowRenderer& renderer) {
        if (!m_window) return;
        renderer.Present();
        m_window->Swap();
    }

private:
    std::unique_ptr<Context> m_context;
    std::unique_ptr<Window> m_window;
    int m_width, m_height;
};

Viewer MakeViewer(const ViewArguments& arguments) {
    Viewer viewer;
    const SceneInput scene = ChooseScene(arguments.scene, arguments.size, arguments.input);
    // A saved world goes on with the settings that it has.
    const std::string_view base = scene.world != nullptr ? std::string_view(scene.world->settings) : comparisonBase;
    viewer.choices = MakeChoices(ParsePanes(arguments.settings.engines, arguments.settings.typed, base));
    viewer.memoryLimit = static_cast<size_t>(arguments.memory) << 20;
    viewer.conditions = arguments.conditions;
    if (!arguments.conditions.when.empty()) viewer.whenText = arguments.conditions.when.front();
    viewer.session.input = arguments.scene;
    viewer.session.size = arguments.size;
    viewer.session.reading = arguments.input;
    viewer.session.settings = arguments.settings;
    viewer.isPaused = arguments.isPaused;
    viewer.showTimes = !arguments.noTimes;
    viewer.look.layers = ParseLayers(arguments.layers);
    viewer.look.overlap = !arguments.noOverlap;
    viewer.look.nodes = ParseNodeSelection(arguments.nodes);
    viewer.look.style = ParseStyle(arguments.style);
    viewer.look.theme = ParseTheme(arguments.theme);
    viewer.camera = ParseCamera(arguments.camera);
    LoadScene(viewer, scene);
    for (int i = 0; i < arguments.stepsBefore && !viewer.mustStop; ++i) StepAll(viewer);
    return viewer;
}

/// Frames to draw; −1: until the window is closed.
int GetFrameCount(const ViewArguments& arguments, const ScriptPlayer& player) {
    if (arguments.frames) return *arguments.frames;
    if (!arguments.script.empty()) return player.GetLastFrame() + 1;
    if (!arguments.isOffscreen && arguments.screenshot.empty() && arguments.dumpState.empty()) return -1;
    throw UsageError("--offscreen, --screenshot and --dump-state need --frames N or --script FILE: when to stop");
}

/// screenshot-<scene>-<step>.png in the current folder.
void SaveRequestedScreenshot(Viewer& viewer, WindowRenderer& renderer) {
    if (!viewer.wantsScreenshot) return;
    viewer.wantsScreenshot = false;
    const std::string name =
        fmt::format("screenshot-{}-{:04}.png", viewer.scene.name, viewer.panes.front().snapshot.step);
    WritePng(name, renderer.Read());
    viewer.message = "wrote " + name;
}

int RunView(const ViewArguments& arguments, const Request& request) {
    const auto [width, height] = ParseSize("--window", arguments.window);
    if (width < 640 || height < 480 || width > 8192 || height > 8192) {
        throw UsageError(fmt::format("--window {}: legal from 640x480 to 8192x8192", arguments.window));
    }
    ScriptPlayer player(arguments.script.empty() ? std::vector<ScriptLine>{}
                                                 : ParseScript(ReadText(arguments.script, "name a script file")));
    const int frames = GetFrameCount(arguments, player);
    Viewer viewer = MakeViewer(arguments);
    Stage stage(arguments, width, height, request.contextOptions);
    const std::unique_ptr<WindowRenderer> renderer = stage.MakeRenderer();
    Gui gui;
    int fontWidth = 0, fontHeight = 0;
    const unsigned char* font = gui.GetFontPixels(fontWidth, fontHeight);
    renderer->SetFont(font, fontWidth, fontHeight);

    // A script or a picture must not depend on how fast this machine is.
    const bool isFixed = arguments.isOffscreen || !arguments.script.empty();
    Items items;
    const Stopwatch watch;
    double before = 0;
    for (int frame = 0; frame != frames && !stage.WantsToClose(); ++frame) {
        std::vector<InputEvent> events = stage.Poll();
        const ScriptFrame script = player.Play(frame, viewer, items);
        events.insert(events.end(), script.events.begin(), script.events.end());
        const double now = watch.GetMilliseconds();
        const double deltaTime = isFixed || frame == 0 ? 1.0 / 60 : (now - before) / 1000;
        before = now;
        if (!arguments.noTimes && frame > 0) {
            viewer.framesPerSecond += 0.1 * (1 / std::max(deltaTime, 1e-6) - viewer.framesPerSecond);
        }
        DrawFrame(viewer, gui, items, *renderer, {events, stage.GetWidth(), stage.GetHeight(), deltaTime});
        stage.Show(*renderer);
        SaveRequestedScreenshot(viewer, *renderer);
        for (const ScriptOutput& output : script.outputs) {
            if (output.isPicture) {
                WritePng(output.path, renderer->Read());
            } else {
                WriteTextFile(output.path, WriteState(viewer));
            }
        }
    }
    if (!arguments.screenshot.empty()) WritePng(arguments.screenshot, renderer->Read());
    if (!arguments.dumpState.empty()) WriteTextFile(arguments.dumpState, WriteState(viewer));
    if (frames > 0) {
        const double seconds = watch.GetMilliseconds() / 1000;
        fmt::print("{} frames in {:.2f} s: {:.1f} frames per second, {} bodies in {} engines\n", frames, seconds,
                   frames / seconds, viewer.panes.front().snapshot.bodies.size(), viewer.panes.size());
    }
    return exitDone;
}

void AddOptions(CLI::App& app, ViewArguments& arguments) {
    app.add_option("SCENE", arguments.scene, DescribeSceneArgument("A scene"))->capture_default_str();
    arguments.input.poses.clear();  // a motion is played as it was recorded
    AddInputOptions(app, arguments.input);
    app.add_option("--size", arguments.size, "Size of a scene that `scree list` shows; its default if not given");
    AddEnginesOption(app, arguments.settings, "");
    AddSetOption(app, arguments.settings, comparisonNote);
    AddSettingFlags(app, arguments.settings, {"broadPhase"});
    std::string names;
    for (const LayerInfo& layer : layerTable) names += (names.empty() ? "" : ", ") + std::string(layer.name);
    app.add_option("--layers", arguments.layers, "What to draw, with commas: " + names)->capture_default_str();
    app.add_option("--nodes", arguments.nodes, "Tree nodes: internal, leaves, all, level=K or levels=A..B")
        ->capture_default_str();
    app.add_option("--style", arguments.style, "Colours of the counts: alpha, heat, bands or log")
        ->capture_default_str();
    app.add_option("--theme", arguments.theme, "Colours of scenes and panels: dark or light")
        ->check(CLI::IsMember({"dark", "light"}))
        ->capture_default_str();
    app.add_option("--camera", arguments.camera,
                   "fit, or X,Y,M: the world point in the middle of a pane, and the metres across it")
        ->capture_default_str();
    app.add_option("--window", arguments.window, "Width x height of the window, pixels")->capture_default_str();
    app.add_flag("--paused", arguments.isPaused, "Start paused");
    app.add_flag("--no-overlap", arguments.noOverlap, "Start without the red overlap of tree nodes");
    app.add_flag("--no-times", arguments.noTimes, "Show no times, so that two runs give the same pictures");
    app.add_option("--steps-before", arguments.stepsBefore, "Steps to run before the first frame")
        ->check(CLI::Range(0, maxStep))
        ->capture_default_str();
    app.add_option("--frames", arguments.frames, "Draw this many frames as fast as possible, then quit")
        ->check(CLI::Range(1, 10'000'000));
    app.add_option("--script", arguments.script, "Play mouse and keyboard events from a file, then quit")
        ->type_name("FILE");
    app.add_option("--screenshot", arguments.screenshot, "Write the last frame as PNG")->type_name("FILE");
    app.add_option("--dump-state", arguments.dumpState, "Write what the window shows at the end as JSON")
        ->type_name("FILE");
    app.add_option("--memory", arguments.memory, "Memory for going back in time, of all panes together, MB")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    AddConditionOptions(app, arguments.conditions, "Break conditions, which pause where they find something");
    app.add_flag("--offscreen", arguments.isOffscreen, "Draw the same pictures without a window or a display");
    app.add_option("--backend", arguments.backend, "With --offscreen: auto (OSMesa, else EGL), osmesa or egl")
        ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
        ->capture_default_str();
}

}  // namespace

void AddViewCommand(CLI::App& app, Request& request) {
    CLI::App* command =
        app.add_subcommand("view", "The window: engines live beside each other, with mouse, layers and trees");
    auto arguments = std::make_shared<ViewArguments>();
    AddOptions(*command, *arguments);
    command->callback(
        [&request, arguments] { request.action = [&request, arguments] { return RunView(*arguments, request); }; });
}

}  // namespace testbed
