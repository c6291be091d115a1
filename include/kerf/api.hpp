// What the library shows to those that link it.
#pragma once

#define KERF_API __attribute__((visibility("default")))
