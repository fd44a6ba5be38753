/** Pages of figures and tables only. */

import { mountFigures } from "./figures.js";
import { watchTables } from "./tables.js";

mountFigures();
watchTables();
