// SPDX-License-Identifier: MIT
import { serve } from "@sinew/skin/worker";
serve();
