"""Animation of a motion."""
class Animation: pass
