// What the library shows to those that link it.
#pragma once

#define KERF_API __attribute__((visibility("default")))
// What it declares to them and keeps for itself.
#define KERF_LOCAL __attribute__((visibility("hidden")))
