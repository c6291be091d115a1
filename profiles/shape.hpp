// Placeholder until the shapes stand beside it.
#pragma once
