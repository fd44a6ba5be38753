"""Files that printers, slicers, drawing programs and shops read."""
