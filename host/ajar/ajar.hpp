// Ajar's public C++ interface: load a glTF scene, pick a Vulkan device, render, get an image.
//
//   auto scene = ajar::SceneFile::load("scene.glb");
//   ajar::RenderDevice device;
//   ajar::RenderSettings settings;
//   settings.samples = 128;
//   ajar::RenderOutput out = ajar::render(scene, device, settings);
//   ajar::write_image("scene.exr", out.image);
//
// Every function throws ajar::Error (one line a user can act on); nothing prints, exits or reads the environment.
#pragma once

#include "base/error.hpp"
#include "base/events.hpp"
#include "image/image.hpp"
#include "render/settings.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>
