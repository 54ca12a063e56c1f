// Ajar's public C++ interface: load a glTF scene, pick a Vulkan device, render, get an image, write it.
//
//   const ajar::SceneFile scene = ajar::SceneFile::load("scene.glb");
//   const ajar::Device device;
//   ajar::RenderSettings settings;
//   settings.samples = 128;
//   const ajar::RenderResult result = ajar::render(scene, device, settings);
//   ajar::save_image("scene.exr", result.image);
//
// Every function throws ajar::Error, whose what() is one line a user can act on; nothing prints, exits or
// reads the environment. Different objects may be used from different threads; one object from one thread at
// a time.
#pragma once

#include "ajar/bake.hpp"
#include "ajar/device.hpp"
#include "ajar/save_image.hpp"
#include "ajar/scene_file.hpp"
#include "ajar/session.hpp"
#include "ajar/version.hpp"
#include "bake/settings.hpp"
#include "base/error.hpp"
#include "base/events.hpp"
#include "image/image.hpp"
#include "radiosity/settings.hpp"
#include "render/settings.hpp"
