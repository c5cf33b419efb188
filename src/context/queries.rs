//! Occlusion queries (OpenGL 1.5, sections 4.1.7 and 6.1.12): how many fragments passed the depth test between BeginQuery
//! and EndQuery. Fragments are counted when the scene is flushed, so both commands flush it: what was drawn before does
//! not count, and the result is there at once.

use super::Values;
use super::engine::Engine;
use super::textures::not_negative;
use crate::enums::*;
use crate::error::{Outcome, invalid_enum, invalid_operation, out_of_memory};
use crate::state::Dirty;

fn occlusion(target: GLenum) -> Outcome {
    if target == GL_SAMPLES_PASSED {
        return Ok(());
    }
    Err(invalid_enum(format!("{} is not a query target; there is GL_SAMPLES_PASSED", name(target))))
}

impl Engine {
    pub(crate) fn gen_queries(&mut self, n: i32, ids: &mut [u32]) -> Outcome {
        not_negative("n", n)?;
        let queries = &mut self.queries;
        queries.results.try_reserve(ids.len()).map_err(|_| out_of_memory("no memory for names of queries"))?;
        for to in ids.iter_mut().take(n as usize) {
            loop {
                queries.next = queries.next.wrapping_add(1);
                if queries.next != 0 && !queries.results.contains_key(&queries.next) {
                    break;
                }
            }
            queries.results.insert(queries.next, None);
            *to = queries.next;
        }
        Ok(())
    }

    pub(crate) fn delete_queries(&mut self, n: i32, ids: &[u32]) -> Outcome {
        not_negative("n", n)?;
        for id in ids.iter().take(n as usize) {
            if self.queries.active == Some(*id) {
                self.stop_counting();
            }
            self.queries.results.remove(id);
        }
        Ok(())
    }

    pub(crate) fn is_query(&mut self, id: u32) -> bool {
        matches!(self.queries.results.get(&id), Some(Some(_)))
    }

    pub(crate) fn begin_query(&mut self, target: GLenum, id: u32) -> Outcome {
        occlusion(target)?;
        if id == 0 {
            return Err(invalid_operation("0 is not the name of a query; ask glGenQueries for one"));
        }
        if let Some(active) = self.queries.active {
            return Err(invalid_operation(format!("query {active} is still active; end it first")));
        }
        self.flush_scene();
        self.queries.results.insert(id, Some(0));
        self.queries.active = Some(id);
        self.queries.passed = 0;
        self.dirty.add(Dirty { vertex: false, fragment: true, raster: false });
        Ok(())
    }

    pub(crate) fn end_query(&mut self, target: GLenum) -> Outcome {
        occlusion(target)?;
        if self.queries.active.is_none() {
            return Err(invalid_operation("no query is active; begin one first"));
        }
        self.stop_counting();
        Ok(())
    }

    fn stop_counting(&mut self) {
        self.flush_scene();
        if let Some(id) = self.queries.active.take() {
            self.queries.results.insert(id, Some(self.queries.passed));
        }
        self.dirty.add(Dirty { vertex: false, fragment: true, raster: false });
    }

    pub(crate) fn get_query(&mut self, target: GLenum, pname: GLenum) -> Outcome<Values> {
        occlusion(target)?;
        match pname {
            GL_CURRENT_QUERY => Ok(Values::uint(self.queries.active.unwrap_or(0))),
            GL_QUERY_COUNTER_BITS => Ok(Values::int(32)),
            _ => Err(invalid_enum(format!("{} is not a property of a query target", name(pname)))),
        }
    }

    pub(crate) fn get_query_object(&mut self, id: u32, pname: GLenum) -> Outcome<Values> {
        let result = match self.queries.results.get(&id) {
            Some(Some(result)) if self.queries.active != Some(id) => *result,
            Some(Some(_)) => return Err(invalid_operation(format!("query {id} is active; end it first"))),
            _ => return Err(invalid_operation(format!("{id} is not the name of a query object"))),
        };
        match pname {
            GL_QUERY_RESULT => Ok(Values::uint(u32::try_from(result).unwrap_or(u32::MAX))),
            GL_QUERY_RESULT_AVAILABLE => Ok(Values::boolean(true)),
            _ => Err(invalid_enum(format!("{} is not a property of a query object", name(pname)))),
        }
    }

    pub(crate) fn list_base(&mut self, base: u32) {
        self.state.list_base = base;
    }

    /// What `glListBase` has set, for the recorder.
    pub(crate) fn current_list_base(&mut self) -> u32 {
        self.state.list_base
    }
}
