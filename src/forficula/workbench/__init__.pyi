from .open import open_workbench as open_workbench
